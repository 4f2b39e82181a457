// What a read means at the place where the walk stands, and what can be done where it is not simply the next one.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "scan/registration.h"

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

Answer Registration::place(const TagRead& read) const {
  const std::string uid = read.uid.text();
  const Stop& here = walk_[*at_];
  const PlaceName name = nameOf(site(), here);
  if (const auto tile = tileWith(site(), read.uid)) {
    if (*tile == name) return {Verdict::Confirmed};
    if (tile->serial == name.serial)
      return {Verdict::OnThisTile,
              phrase("Core", "Tag %1 is registered already, as tag %2 of this tile.").with(uid, tile->tag + 1), tile};
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

std::vector<Put> Registration::exchange(const floor::TagUid& uid) const {
  const auto there = at_ ? tileWith(site(), uid) : std::nullopt;
  if (!there) return {};
  const PlaceName here = nameOf(site(), walk_[*at_]);
  if (there->serial != here.serial || *there == here) return {};
  return {{*there, uidAt(site(), walk_[*at_])}, {here, uid}};
}

std::vector<Put> Registration::anew() const {
  std::vector<Put> puts;
  if (!at_) return puts;
  const floor::Tile& tile = site().tiles[walk_[*at_].tile];
  for (std::size_t n = 0; n < tile.uids.size(); ++n) puts.push_back({{tile.serial, n}, {}});
  return puts;
}

}  // namespace tessera::scan
