// Tiles upon one another, and tiles laid a little off their neighbours.
#include <algorithm>
#include <cmath>
#include <map>

#include "sitecheck/checks.h"
#include "sitecheck/lattice.h"
#include "sitecheck/wording.h"

namespace tessera::sitecheck {
namespace {

struct Share {
  double x;
  double y;
};
// How far the boxes reach into one another along each axis; negative: how far they are apart.
Share shared(const Box& a, const Box& b) {
  return {(std::min(a.high.x, b.high.x) - std::max(a.low.x, b.low.x)).value(),
          (std::min(a.high.y, b.high.y) - std::max(a.low.y, b.low.y)).value()};
}
Box common(const Box& a, const Box& b) {
  return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
          {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}};
}
double widthOf(const Box& b) { return (b.high.x - b.low.x).value(); }
double heightOf(const Box& b) { return (b.high.y - b.low.y).value(); }

bool lieUpon(const Box& a, const Box& b, Metres most) {
  const auto [x, y] = shared(a, b);
  const double seam = most.value();
  return x > std::min(seam, 0.25 * std::min(widthOf(a), widthOf(b))) &&
         y > std::min(seam, 0.25 * std::min(heightOf(a), heightOf(b)));
}

// Neighbours edge to edge: along x or along y, the other axis shared for more than half. Nothing: they are none. Else
// how b has to move to lie on a's lattice; which of the two comes first does not matter to whether it has to.
std::optional<Offset> misfit(const Box& a, const Box& b, const CheckOptions& options) {
  const auto [x, y] = shared(a, b);
  const double seam = options.seam.value();
  const double exact = options.exact.value();
  const bool alongX = std::abs(x) <= seam && y > 0.5 * std::min(heightOf(a), heightOf(b));
  const bool alongY = std::abs(y) <= seam && x > 0.5 * std::min(widthOf(a), widthOf(b));
  if (!alongX && !alongY) return std::nullopt;
  // Apart is positive; tiles of one length along the seam also lie side by side, or shifted on purpose by more.
  const double apart = alongX ? -x : -y;
  const bool after = alongX ? b.low.x > a.low.x : b.low.y > a.low.y;
  const double aside = alongX ? (b.low.y - a.low.y).value() : (b.low.x - a.low.x).value();
  const bool alike = alongX ? std::abs(heightOf(a) - heightOf(b)) <= exact : std::abs(widthOf(a) - widthOf(b)) <= exact;
  const double across = alike && std::abs(aside) > exact && std::abs(aside) <= seam ? -aside : 0.0;
  const double along = std::abs(apart) > exact ? (after ? -apart : apart) : 0.0;
  return alongX ? Offset{Metres{along}, Metres{across}} : Offset{Metres{across}, Metres{along}};
}

bool fits(const Offset& off) { return off.x == Metres{} && off.y == Metres{}; }

// Where neighbours of a tile lie. A little farther than what counts, so that no rounding decides.
Box around(const Box& box, const CheckOptions& options) { return grown(box, options.seam + Metres{1e-6}); }

const std::string& serialOf(const Context& context, std::uint32_t laid) {
  return context.site.tiles[context.plan.laid()[laid].tile].serial;
}

Fault overlap(const Context& context, std::uint32_t a, std::uint32_t b) {
  const std::string& one = serialOf(context, a);
  const std::string& other = serialOf(context, b);
  const Box box = common(context.plan.laid()[a].box, context.plan.laid()[b].box);
  Fault fault{
      .sentence = phrase("Core", "Tiles \"%1\" and \"%2\" lie upon one another, over %3 × %4 cm.")
                      .with(one, other, inCentimetres(box.high.x - box.low.x), inCentimetres(box.high.y - box.low.y)),
      .objects = {{ObjectKind::Tile, other}, {ObjectKind::Tile, one}}};
  // Only where one lies just where the other does is it plain that one of them is too many.
  const floor::Placement& later = context.site.placements[context.plan.laid()[b].placement];
  if (distance(context.plan.laid()[a].box.low, context.plan.laid()[b].box.low) <= context.options.seam)
    fault.fix = Fix{phrase("Core", "Take tile \"%1\" up").with(other), TakeTileUp{later}};
  return fault;
}

// Of two that do not fit the one is off that fits fewer others; of equals the later one.
void tellOff(const Context& context, const Lattice& lattice, Faults& faults) {
  struct Blame {
    std::uint32_t neighbour;
    Offset by;
  };
  std::map<std::uint32_t, Blame> off;
  for (const Lattice::Misfit& pair : lattice.misfits()) {
    const bool first = lattice.fitsOf(pair.a) < lattice.fitsOf(pair.b);
    const std::uint32_t culprit = first ? pair.a : pair.b;
    const Blame blame{first ? pair.b : pair.a, first ? -1.0 * pair.off : pair.off};
    const auto [known, isNew] = off.try_emplace(culprit, blame);
    if (!isNew && lattice.fitsOf(blame.neighbour) > lattice.fitsOf(known->second.neighbour)) known->second = blame;
  }
  FaultList list{faults, FaultKind::TileOffLattice, Severity::Warning, context.options.mostOfAKind};
  for (const auto& [tile, blame] : off) {
    const LaidTile& laid = context.plan.laid()[tile];
    const floor::Placement& placement = context.site.placements[laid.placement];
    const Point moved = placement.origin + blame.by;
    // To the micrometre: 1.8 and not 1.7999999999999998.
    const auto rounded = [](Metres m) { return Metres{std::round(m.value() * 1e6) / 1e6}; };
    const Point target{rounded(moved.x), rounded(moved.y)};
    list.add(laid.box, [&, serial = serialOf(context, tile), other = serialOf(context, blame.neighbour),
                        by = length(blame.by)] {
      return Fault{
          .sentence =
              phrase("Core", "Tile \"%1\" lies %2 cm off its neighbour \"%3\".").with(serial, inCentimetres(by), other),
          .objects = {{ObjectKind::Tile, serial}, {ObjectKind::Tile, other}},
          .fix = Fix{phrase("Core", "Move tile \"%1\" up to tile \"%2\"").with(serial, other),
                     MoveTile{placement, target}}};
    });
  }
  list.close();
}

}  // namespace

Lattice::Lattice(const FloorPlan& plan, const CheckOptions& options) : fits_(plan.laid().size(), 0) {
  for (std::uint32_t i = 0; i < plan.laid().size(); ++i)
    plan.finder().forEachIn(around(plan.laid()[i].box, options), [&](std::size_t j) {
      if (j > i) compare(plan, options, i, static_cast<std::uint32_t>(j));
    });
  sort();
}

void Lattice::compare(const FloorPlan& plan, const CheckOptions& options, std::uint32_t a, std::uint32_t b) {
  const Box& first = plan.laid()[a].box;
  const Box& second = plan.laid()[b].box;
  if (lieUpon(first, second, options.seam)) {
    overlaps_.emplace_back(a, b);
  } else if (const auto off = misfit(first, second, options)) {
    if (fits(*off)) {
      ++fits_[a];
      ++fits_[b];
    } else {
      misfits_.push_back({a, b, *off});
    }
  }
}

void Lattice::sort() {
  std::sort(overlaps_.begin(), overlaps_.end());
  std::sort(misfits_.begin(), misfits_.end(), [](const Misfit& m, const Misfit& n) {
    return std::pair{m.a, m.b} < std::pair{n.a, n.b};
  });
}

void Lattice::follow(const FloorPlan& plan, const CheckOptions& options, const FloorChange& change) {
  const Alignment& laid = change.laid;
  std::vector<std::uint16_t> fit(plan.laid().size(), 0);
  for (std::size_t i = 0; i < fit.size(); ++i)
    if (laid.wasAt[i] != kGone) fit[i] = fits_[laid.wasAt[i]];
  fits_ = std::move(fit);
  const auto isGone = [&laid](std::uint32_t& a, std::uint32_t& b) {
    a = laid.nowAt[a];
    b = laid.nowAt[b];
    return a == kGone || b == kGone;
  };
  std::erase_if(overlaps_, [&](auto& pair) { return isGone(pair.first, pair.second); });
  std::erase_if(misfits_, [&](Misfit& pair) { return isGone(pair.a, pair.b); });
  // Who stays fitted those that are gone; who is gone counts no more.
  for (const Box& box : change.goneBoxes)
    plan.finder().forEachIn(around(box, options), [&](std::size_t j) {
      const Box& other = plan.laid()[j].box;
      if (laid.wasAt[j] == kGone || lieUpon(box, other, options.seam)) return;
      if (const auto off = misfit(box, other, options); off && fits(*off)) --fits_[j];
    });
  for (const std::uint32_t i : laid.fresh)
    plan.finder().forEachIn(around(plan.laid()[i].box, options), [&](std::size_t found) {
      const auto j = static_cast<std::uint32_t>(found);
      // A pair of new ones is met twice.
      if (j == i || (j < i && laid.wasAt[j] == kGone)) return;
      compare(plan, options, std::min(i, j), std::max(i, j));
    });
  sort();
}

Faults checkLattice(const Context& context) {
  Faults faults;
  FaultList overlaps{faults, FaultKind::TilesOverlap, Severity::Error, context.options.mostOfAKind};
  for (const auto& [a, b] : context.lattice.overlaps())
    overlaps.add(common(context.plan.laid()[a].box, context.plan.laid()[b].box),
                 [&, one = a, other = b] { return overlap(context, one, other); });
  overlaps.close();
  tellOff(context, context.lattice, faults);
  return faults;
}

}  // namespace tessera::sitecheck
