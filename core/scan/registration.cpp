#include "scan/registration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace tessera::scan {
namespace {

using Verdict = Answer::Verdict;

std::string centimetres(Metres m) {
  std::array<char, 32> text{};
  const double whole = std::round(m.value() * 100.0) / 100.0;
  std::snprintf(text.data(), text.size(), "%.2f", whole == 0.0 ? 0.0 : whole);
  return text.data();
}

std::optional<PlaceName> tileWith(const floor::Site& site, const floor::TagUid& uid) {
  for (const floor::Tile& tile : site.tiles) {
    const auto found = std::find(tile.uids.begin(), tile.uids.end(), uid);
    if (found != tile.uids.end()) return PlaceName{tile.serial, static_cast<std::size_t>(found - tile.uids.begin())};
  }
  return std::nullopt;
}

const floor::LooseTag* looseWith(const floor::Site& site, const floor::TagUid& uid) {
  const auto found = std::find_if(site.looseTags.begin(), site.looseTags.end(),
                                  [&](const floor::LooseTag& tag) { return tag.uid == uid; });
  return found == site.looseTags.end() ? nullptr : &*found;
}

}  // namespace

Registration::Registration(std::shared_ptr<const floor::SiteMap> map, Course course)
    : map_{std::move(map)}, course_{std::move(course)} {
  rebuild();
}

// Places are kept by name while the walk is made anew.
void Registration::rebuild() {
  walk_ = walkOver(site(), course_.order, course_.tile);
  skipped_.assign(walk_.size(), false);
  for (const PlaceName& place : course_.skipped)
    if (const auto stop = find(place)) skipped_[*stop] = true;
  at_ = course_.at ? find(*course_.at) : std::nullopt;
  if (at_ && (course_.again || isOpen(*at_))) return;
  if (course_.again)
    at_ = walk_.empty() ? std::nullopt : std::optional<std::size_t>{0};
  else
    at_ = openFrom(at_.value_or(0));
}

Course Registration::course() const {
  Course course = course_;
  course.at = at_ ? std::optional{nameOf(site(), walk_[*at_])} : std::nullopt;
  course.skipped.clear();
  for (std::size_t i = 0; i < walk_.size(); ++i)
    if (skipped_[i]) course.skipped.push_back(nameOf(site(), walk_[i]));
  return course;
}

std::optional<std::size_t> Registration::find(const PlaceName& place) const {
  const auto& tiles = site().tiles;
  const auto tile =
      std::find_if(tiles.begin(), tiles.end(), [&](const floor::Tile& t) { return t.serial == place.serial; });
  const auto number = static_cast<std::size_t>(tile - tiles.begin());
  const auto found = std::find_if(walk_.begin(), walk_.end(),
                                  [&](const Stop& stop) { return stop.tile == number && stop.tag == place.tag; });
  return found == walk_.end() ? std::nullopt : std::optional{static_cast<std::size_t>(found - walk_.begin())};
}

// Round the walk: what was passed by comes at the end.
std::optional<std::size_t> Registration::openFrom(std::size_t stop) const {
  for (std::size_t n = 0; n < walk_.size(); ++n)
    if (const std::size_t i = (stop + n) % walk_.size(); isOpen(i)) return i;
  return std::nullopt;
}

void Registration::siteChanged(std::shared_ptr<const floor::SiteMap> map) {
  const auto before = std::exchange(map_, std::move(map));
  if (!samePlaces(before->site(), site())) {
    const auto now = std::exchange(map_, before);
    course_ = course();
    map_ = now;
    done_.clear();
    rebuild();
    return;
  }
  bool undone = false;
  while (!done_.empty() && !done_.back().uid.empty() && uidAt(site(), walk_[done_.back().stop]) != done_.back().uid) {
    at_ = done_.back().stop;
    done_.pop_back();
    undone = true;
  }
  if (undone) {
    last_ = {};
    return;
  }
  // Registered by another way, a redo say.
  const bool filled =
      at_ && uidAt(before->site(), walk_[*at_]).empty() && !uidAt(site(), walk_[*at_]).empty() && !course_.again;
  if (filled || (!at_ && !course_.again)) at_ = openFrom(at_.value_or(0));
}

Answer Registration::place(const TagRead& read) const {
  const std::string uid = read.uid.text();
  const Stop& here = walk_[*at_];
  const PlaceName name = nameOf(site(), here);
  if (const auto tile = tileWith(site(), read.uid)) {
    if (*tile == name) return {Verdict::Confirmed};
    return {Verdict::InUse,
            phrase("Core", "Tag %1 is registered already, as tag %2 of tile \"%3\".")
                .with(uid, tile->tag + 1, tile->serial),
            tile};
  }
  if (const floor::LooseTag* loose = looseWith(site(), read.uid))
    return {Verdict::InUse, phrase("Core", "Tag %1 is registered already, as a loose tag at (%2, %3) m.")
                                .with(uid, centimetres(loose->place.x), centimetres(loose->place.y))};
  if (!read.place || !here.place || distance(*read.place, *here.place) <= kSamePlace) return {Verdict::Accepted};
  const std::string x = centimetres(read.place->x);
  const std::string y = centimetres(read.place->y);
  const auto there = std::find_if(walk_.begin(), walk_.end(), [&](const Stop& stop) {
    return stop.place && distance(*stop.place, *read.place) <= kSamePlace;
  });
  if (there == walk_.end())
    return {Verdict::Elsewhere,
            phrase("Core", "Tag %1 says that it lies at (%2, %3) m, %4 m from here, where no tag is to be registered.")
                .with(uid, x, y, centimetres(distance(*read.place, *here.place)))};
  const PlaceName other = nameOf(site(), *there);
  return {Verdict::Elsewhere,
          phrase("Core", "Tag %1 says that it lies at (%2, %3) m: that is tag %4 of tile \"%5\".")
              .with(uid, x, y, other.tag + 1, other.serial),
          other};
}

Answer Registration::offer(const TagRead& read, Seconds now) {
  const bool sameVisit = read.uid == seen_ && now - seenAt_ <= kSameVisit;
  seen_ = read.uid;
  seenAt_ = now;
  if (sameVisit || read.uid == last_) return {Verdict::Repeated};
  if (!at_) return {Verdict::Finished, phrase("Core", "All places are registered or skipped.")};
  return place(read);
}

void Registration::registered(std::shared_ptr<const floor::SiteMap> map, const floor::TagUid& uid, Seconds now) {
  if (!at_) return;
  done_.push_back({*at_, uidAt(site(), walk_[*at_]), uid});
  map_ = std::move(map);
  pace_.registered(now);
  last_ = uid;
  skipped_[*at_] = false;
  moveOn();
}

void Registration::moveOn() {
  if (!course_.again) {
    at_ = openFrom((*at_ + 1) % walk_.size());
    return;
  }
  std::size_t stop = *at_ + 1;
  while (stop < walk_.size() && skipped_[stop]) ++stop;
  at_ = stop < walk_.size() ? std::optional{stop} : std::nullopt;
}

void Registration::skip() {
  if (!at_) return;
  done_.push_back({*at_, {}, {}});
  skipped_[*at_] = true;
  last_ = {};
  moveOn();
}

bool Registration::next() {
  if (!at_ || *at_ + 1 >= walk_.size()) return false;
  ++*at_;
  last_ = {};
  return true;
}

bool Registration::previous() {
  const std::size_t from = at_.value_or(walk_.size());
  if (from == 0) return false;
  at_ = from - 1;
  last_ = {};
  return true;
}

bool Registration::goTo(const PlaceName& place) {
  const auto stop = find(place);
  if (!stop) return false;
  at_ = stop;
  last_ = {};
  return true;
}

void Registration::takeUpSkipped() {
  const auto first = std::find(skipped_.begin(), skipped_.end(), true);
  if (!at_ && first != skipped_.end()) at_ = static_cast<std::size_t>(first - skipped_.begin());
  skipped_.assign(walk_.size(), false);
}

std::optional<Registration::Step> Registration::back() {
  last_ = {};
  if (done_.empty()) {
    previous();
    return std::nullopt;
  }
  const Done done = done_.back();
  done_.pop_back();
  at_ = done.stop;
  if (done.uid.empty()) skipped_[done.stop] = false;
  return Step{nameOf(site(), walk_[done.stop]), done.before, !done.uid.empty()};
}

Registration::Progress Registration::progress() const {
  Progress p;
  p.places = walk_.size();
  for (std::size_t i = 0; i < walk_.size(); ++i) {
    if (!uidAt(site(), walk_[i]).empty())
      ++p.registered;
    else if (skipped_[i])
      ++p.skipped;
  }
  p.left = course_.again ? (at_ ? walk_.size() - *at_ : 0) : p.places - p.registered - p.skipped;
  p.perTag = pace_.perTag();
  p.timeLeft = pace_.timeFor(p.left);
  return p;
}

}  // namespace tessera::scan
