#include "scan/registration.h"

#include <algorithm>
#include <utility>

namespace tessera::scan {

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

std::optional<std::vector<floor::TagUid>> Registration::siteChanged(std::shared_ptr<const floor::SiteMap> map) {
  const auto before = std::exchange(map_, std::move(map));
  if (!samePlaces(before->site(), site())) {
    const auto now = std::exchange(map_, before);
    course_ = course();
    map_ = now;
    done_.clear();
    rebuild();
    return std::nullopt;
  }
  std::optional<std::vector<floor::TagUid>> undone;
  while (!done_.empty() && !stands(done_.back())) {
    if (!undone) undone.emplace();
    for (const Done::Tag& tag : takeOff().tags)
      if (!tag.after.empty() && tag.before != tag.after) undone->push_back(tag.after);
  }
  if (undone) {
    last_ = {};
    return undone;
  }
  // Registered by another way, a redo say.
  const bool filled =
      at_ && uidAt(before->site(), walk_[*at_]).empty() && !uidAt(site(), walk_[*at_]).empty() && !course_.again;
  if (filled || (!at_ && !course_.again)) at_ = openFrom(at_.value_or(0));
  return std::nullopt;
}

// What differs on the tile of the place between the site as it was and as it is now.
Registration::Done Registration::doneTo(const floor::Site& now) const {
  const Stop& here = walk_[*at_];
  Done done{*at_};
  const std::size_t most = std::max(site().tiles[here.tile].uids.size(), now.tiles[here.tile].uids.size());
  for (std::uint32_t n = 0; n < std::max<std::size_t>(most, here.tag + 1); ++n) {
    const Stop stop{here.tile, n, std::nullopt};
    Done::Tag tag{n, uidAt(site(), stop), uidAt(now, stop)};
    if (n == here.tag || tag.before != tag.after) done.tags.push_back(tag);
  }
  return done;
}

bool Registration::stands(const Done& done) const {
  const std::uint32_t tile = walk_[done.stop].tile;
  return std::all_of(done.tags.begin(), done.tags.end(), [&](const Done::Tag& tag) {
    return uidAt(site(), {tile, tag.tag, std::nullopt}) == tag.after;
  });
}

Registration::Done Registration::takeOff() {
  Done done = std::move(done_.back());
  done_.pop_back();
  at_ = done.stop;
  if (done.tags.empty()) skipped_[done.stop] = false;
  for (const std::size_t stop : done.taken) skipped_[stop] = true;
  return done;
}

void Registration::registered(std::shared_ptr<const floor::SiteMap> map, const floor::TagUid& uid, Seconds now) {
  if (!at_) return;
  Done done = doneTo(map->site());
  if (skipped_[*at_]) done.taken.push_back(*at_);
  done_.push_back(std::move(done));
  map_ = std::move(map);
  pace_.registered(now);
  last_ = uid;
  skipped_[*at_] = false;
  moveOn();
}

void Registration::cleared(std::shared_ptr<const floor::SiteMap> map) {
  if (!at_) return;
  Done done = doneTo(map->site());
  const std::uint32_t tile = walk_[*at_].tile;
  map_ = std::move(map);
  last_ = {};
  at_.reset();
  for (std::size_t i = 0; i < walk_.size(); ++i) {
    if (walk_[i].tile != tile) continue;
    if (!at_) at_ = i;
    if (skipped_[i]) done.taken.push_back(i);
    skipped_[i] = false;
  }
  done_.push_back(std::move(done));
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
  done_.push_back({*at_});
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

std::vector<Put> Registration::back() {
  last_ = {};
  if (done_.empty()) {
    previous();
    return {};
  }
  const Done done = takeOff();
  const std::string& serial = site().tiles[walk_[done.stop].tile].serial;
  std::vector<Put> puts;
  for (const Done::Tag& tag : done.tags)
    if (tag.before != tag.after) puts.push_back({{serial, tag.tag}, tag.before});
  return puts;
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
