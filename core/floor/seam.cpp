#include "floor/seam.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tessera::floor {
namespace {

constexpr double kSame = 1e-6;

// A tag of the tile (0) or of its neighbour (1).
struct Sided {
  Offset place;
  int tile = 0;
};

// Closest two that `counts` admits: a sweep from left to right that looks back no farther than the best so far.
template <class Counts>
double closest(std::vector<Sided> tags, Counts counts) {
  std::sort(tags.begin(), tags.end(), [](const Sided& a, const Sided& b) { return a.place.x < b.place.x; });
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < tags.size(); ++i) {
    for (std::size_t j = i; j-- > 0 && (tags[i].place.x - tags[j].place.x).value() < least;) {
      if (counts(tags[i], tags[j])) least = std::min(least, length(tags[i].place + -1.0 * tags[j].place).value());
    }
  }
  return least;
}

std::vector<Sided> tagsOf(const TileType& type, Offset shift, int tile) {
  std::vector<Sided> tags;
  for (const Offset& place : tagOffsets(type)) tags.push_back({place + shift, tile});
  return tags;
}

}  // namespace

std::optional<Metres> closestTags(const TileType& type) {
  const double least = closest(tagsOf(type, {}, 0), [](const Sided&, const Sided&) { return true; });
  return std::isfinite(least) ? std::optional{Metres{least}} : std::nullopt;
}

Seam seamOf(const TileType& type, Side side) {
  const bool right = side == Side::Right;
  const Metres length = right ? type.width : type.height;
  Seam seam;
  seam.pitch = length - ((right ? type.columns : type.rows) - 1) * type.pitch;
  const double more = (seam.pitch - type.pitch).value();
  seam.fit = std::abs(more) <= kSame ? Seam::Fit::Even : more < 0.0 ? Seam::Fit::Closer : Seam::Fit::Wider;

  std::vector<Sided> all = tagsOf(type, {}, 0);
  const std::vector<Sided> next = tagsOf(type, right ? Offset{length, {}} : Offset{{}, length}, 1);
  const double within = closest(all, [](const Sided&, const Sided&) { return true; });
  all.insert(all.end(), next.begin(), next.end());
  const double across = closest(all, [](const Sided& a, const Sided& b) { return a.tile != b.tile; });
  if (!std::isfinite(within) || !(across < within - kSame)) return seam;
  seam.apart = Metres{across};
  // Only tags that near to the seam can meet: the rest of a large tile need not be compared.
  const auto along = [right](Offset o) { return (right ? o.x : o.y).value(); };
  for (const Sided& here : all) {
    if (here.tile != 0 || along(here.place) < length.value() - across - kSame) continue;
    for (const Sided& there : next) {
      if (along(there.place) > length.value() + across + kSame) continue;
      if (tessera::length(there.place + -1.0 * here.place).value() <= across + kSame)
        seam.meeting.emplace_back(here.place, there.place);
    }
  }
  return seam;
}

}  // namespace tessera::floor
