// Tiles upon one another, and tiles laid a little off their neighbours.
#include <algorithm>
#include <cmath>
#include <map>

#include "sitecheck/checks.h"
#include "sitecheck/wording.h"

namespace tessera::sitecheck {
namespace {

// How tile b lies to tile a.
struct Pair {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  Offset off;  ///< b, moved by this, lies on a's lattice
};

class Floor {
public:
  explicit Floor(const Context& context) : context_{context}, fits_(context.plan.laid().size(), 0) {}

  Faults check() {
    Faults faults;
    FaultList overlaps{faults, FaultKind::TilesOverlap, Severity::Error, context_.options.mostOfAKind};
    const auto& laid = context_.plan.laid();
    std::vector<std::uint32_t> near;
    for (std::uint32_t i = 0; i < laid.size(); ++i) {
      near.clear();
      context_.plan.tree().forEachIn(grown(laid[i].box, context_.options.seam), [&](std::size_t j) {
        if (j > i) near.push_back(static_cast<std::uint32_t>(j));
      });
      std::sort(near.begin(), near.end());
      for (const std::uint32_t j : near) {
        if (lieUpon(laid[i].box, laid[j].box))
          overlaps.add(common(laid[i].box, laid[j].box), [&] { return overlap(i, j); });
        else
          compare(i, j);
      }
    }
    overlaps.close();
    tellOff(faults);
    return faults;
  }

private:
  struct Share {
    double x;
    double y;
  };
  // How far the boxes reach into one another along each axis; negative: how far they are apart.
  static Share shared(const Box& a, const Box& b) {
    return {(std::min(a.high.x, b.high.x) - std::max(a.low.x, b.low.x)).value(),
            (std::min(a.high.y, b.high.y) - std::max(a.low.y, b.low.y)).value()};
  }
  static Box common(const Box& a, const Box& b) {
    return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
            {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}};
  }
  static double width(const Box& b) { return (b.high.x - b.low.x).value(); }
  static double height(const Box& b) { return (b.high.y - b.low.y).value(); }
  static double least(double a, double b) { return std::min(a, b); }

  [[nodiscard]] bool lieUpon(const Box& a, const Box& b) const {
    const auto [x, y] = shared(a, b);
    const double seam = context_.options.seam.value();
    return x > least(seam, 0.25 * least(width(a), width(b))) && y > least(seam, 0.25 * least(height(a), height(b)));
  }
  [[nodiscard]] const std::string& serialOf(std::uint32_t laid) const {
    return context_.site.tiles[context_.plan.laid()[laid].tile].serial;
  }

  [[nodiscard]] Fault overlap(std::uint32_t a, std::uint32_t b) const {
    const Box box = common(context_.plan.laid()[a].box, context_.plan.laid()[b].box);
    Fault fault{.sentence = phrase("Core", "Tiles \"%1\" and \"%2\" lie upon one another, over %3 × %4 cm.")
                                .with(serialOf(a), serialOf(b), inCentimetres(box.high.x - box.low.x),
                                      inCentimetres(box.high.y - box.low.y)),
                .objects = {{ObjectKind::Tile, serialOf(b)}, {ObjectKind::Tile, serialOf(a)}}};
    // Only where one lies just where the other does is it plain that one of them is too many.
    const floor::Placement& later = context_.site.placements[context_.plan.laid()[b].placement];
    if (distance(context_.plan.laid()[a].box.low, context_.plan.laid()[b].box.low) <= context_.options.seam)
      fault.fix = Fix{phrase("Core", "Take tile \"%1\" up").with(serialOf(b)), TakeTileUp{later}};
    return fault;
  }

  // Neighbours edge to edge: along x or along y, the other axis shared for more than half.
  void compare(std::uint32_t i, std::uint32_t j) {
    const Box& a = context_.plan.laid()[i].box;
    const Box& b = context_.plan.laid()[j].box;
    const auto [x, y] = shared(a, b);
    const double seam = context_.options.seam.value();
    const double exact = context_.options.exact.value();
    const bool alongX = std::abs(x) <= seam && y > 0.5 * least(height(a), height(b));
    const bool alongY = std::abs(y) <= seam && x > 0.5 * least(width(a), width(b));
    if (!alongX && !alongY) return;
    // Apart is positive; tiles of one length along the seam also lie side by side, or shifted on purpose by more.
    const double apart = alongX ? -x : -y;
    const bool after = alongX ? b.low.x > a.low.x : b.low.y > a.low.y;
    const double aside = alongX ? (b.low.y - a.low.y).value() : (b.low.x - a.low.x).value();
    const bool alike = alongX ? std::abs(height(a) - height(b)) <= exact : std::abs(width(a) - width(b)) <= exact;
    const double across = alike && std::abs(aside) > exact && std::abs(aside) <= seam ? -aside : 0.0;
    const double along = std::abs(apart) > exact ? (after ? -apart : apart) : 0.0;
    if (along == 0.0 && across == 0.0) {
      ++fits_[i];
      ++fits_[j];
    } else {
      pairs_.push_back({i, j, alongX ? Offset{Metres{along}, Metres{across}} : Offset{Metres{across}, Metres{along}}});
    }
  }

  // Of two that do not fit the one is off that fits fewer others; of equals the later one.
  void tellOff(Faults& faults) const {
    struct Blame {
      std::uint32_t neighbour;
      Offset by;
    };
    std::map<std::uint32_t, Blame> off;
    for (const Pair& pair : pairs_) {
      const bool first = fits_[pair.a] < fits_[pair.b];
      const std::uint32_t culprit = first ? pair.a : pair.b;
      const Blame blame{first ? pair.b : pair.a, first ? -1.0 * pair.off : pair.off};
      const auto [known, isNew] = off.try_emplace(culprit, blame);
      if (!isNew && fits_[blame.neighbour] > fits_[known->second.neighbour]) known->second = blame;
    }
    FaultList list{faults, FaultKind::TileOffLattice, Severity::Warning, context_.options.mostOfAKind};
    for (const auto& [tile, blame] : off) {
      const LaidTile& laid = context_.plan.laid()[tile];
      const floor::Placement& placement = context_.site.placements[laid.placement];
      const Point moved = placement.origin + blame.by;
      // To the micrometre: 1.8 and not 1.7999999999999998.
      const auto rounded = [](Metres m) { return Metres{std::round(m.value() * 1e6) / 1e6}; };
      const Point target{rounded(moved.x), rounded(moved.y)};
      list.add(laid.box, [&, serial = serialOf(tile), other = serialOf(blame.neighbour), by = length(blame.by)] {
        return Fault{.sentence = phrase("Core", "Tile \"%1\" lies %2 cm off its neighbour \"%3\".")
                                     .with(serial, inCentimetres(by), other),
                     .objects = {{ObjectKind::Tile, serial}, {ObjectKind::Tile, other}},
                     .fix = Fix{phrase("Core", "Move tile \"%1\" up to tile \"%2\"").with(serial, other),
                                MoveTile{placement, target}}};
      });
    }
    list.close();
  }

  const Context& context_;
  std::vector<std::uint16_t> fits_;  ///< for each laid tile: neighbours that it fits
  std::vector<Pair> pairs_;
};

}  // namespace

Faults checkLattice(const Context& context) { return Floor{context}.check(); }

}  // namespace tessera::sitecheck
