// How long a vehicle on a route goes without seeing a tag.
#include <algorithm>
#include <cmath>

#include "base/polyline.h"
#include "sitecheck/body.h"
#include "sitecheck/checks.h"
#include "sitecheck/outline.h"
#include "sitecheck/wording.h"

namespace tessera::sitecheck {
namespace {

// Ways along the route, from its start, over which some reader sees some tag.
struct Sighted {
  double from;
  double to;
};

class Sight {
public:
  Sight(const Context& context, const floor::VehicleSetup& vehicle) : context_{context}, vehicle_{vehicle} {}

  std::vector<Sighted> along(const Polyline& line) {
    for (std::size_t leg = 0; leg < line.legCount(); ++leg) {
      heading_ = line.headingOf(leg);
      start_ = line.vertices()[leg];
      before_ = line.startOf(leg).value();
      length_ = line.startOf(leg + 1).value() - before_;
      // A long slanting leg has a box that holds half the floor: it is looked at piece by piece.
      const int pieces = static_cast<int>(std::ceil(length_ / 2.0));
      for (int i = 0; i < pieces; ++i) piece(length_ * i / pieces, length_ * (i + 1) / pieces);
    }
    std::sort(seen_.begin(), seen_.end(), [](const Sighted& a, const Sighted& b) { return a.from < b.from; });
    return std::move(seen_);
  }

private:
  void piece(double from, double to) {
    double reach = 0.0;
    for (const Offset& reader : vehicle_.readers) reach = std::max(reach, length(reader).value());
    const Point ends[] = {start_ + turned({Metres{from}, {}}, heading_), start_ + turned({Metres{to}, {}}, heading_)};
    const Box around = grown(boxAround(ends), Metres{reach} + vehicle_.readerRadius);
    context_.plan.finder().forEachIn(around, [&](std::size_t i) {
      const LaidTile& laid = context_.plan.laid()[i];
      const auto& uids = context_.site.tiles[laid.tile].uids;
      const std::size_t tags = std::min(uids.size(), context_.plan.offsetsOf(laid.type).size());
      for (std::size_t n = 0; n < tags; ++n)
        if (!uids[n].empty()) look(context_.plan.placeOf(context_.site, laid, n));
    });
    context_.looseTags.forEachIn(around, [&](std::size_t i) {
      if (!context_.site.looseTags[i].uid.empty()) look(context_.site.looseTags[i].place);
    });
  }

  void look(Point tag) {
    const Offset off = turned(tag - start_, -heading_);
    for (const Offset& reader : vehicle_.readers) {
      const double r = vehicle_.readerRadius.value();
      const double aside = off.y.value() - reader.y.value();
      if (!(std::abs(aside) <= r)) continue;
      const double half = std::sqrt(r * r - aside * aside);
      const double middle = off.x.value() - reader.x.value();
      const double from = std::max(middle - half, 0.0);
      const double to = std::min(middle + half, length_);
      if (from <= to) seen_.push_back({before_ + from, before_ + to});
    }
  }

  const Context& context_;
  const floor::VehicleSetup& vehicle_;
  Radians heading_;
  Point start_;
  double before_ = 0.0;
  double length_ = 0.0;
  std::vector<Sighted> seen_;
};

Sighted longestBlind(const std::vector<Sighted>& seen, double length) {
  Sighted longest{0.0, 0.0};
  double at = 0.0;
  const auto until = [&](double next) {
    if (next - at > longest.to - longest.from) longest = {at, next};
  };
  for (const Sighted& s : seen) {
    until(s.from);
    at = std::max(at, s.to);
  }
  until(length);
  return longest;
}

Box boxOfWay(const Polyline& line, const Sighted& way) {
  std::vector<Point> points{line.at(Metres{way.from}), line.at(Metres{way.to})};
  for (std::size_t i = 0; i < line.vertices().size(); ++i)
    if (line.startOf(i).value() > way.from && line.startOf(i).value() < way.to) points.push_back(line.vertices()[i]);
  return boxAround(points);
}

}  // namespace

bool passesNear(const Context& context, const floor::Route& route, std::span<const Box> places) {
  constexpr std::size_t many = 256;
  if (places.size() > many || route.vertices.empty() || !isPlace(boxAround(route.vertices))) return true;
  Metres reach;
  for (const floor::VehicleSetup* vehicle : readerRowsOf(context.site))
    for (const Offset& reader : vehicle->readers) reach = std::max(reach, length(reader) + vehicle->readerRadius);
  const Polyline line{withoutRepeats(route.vertices, false)};
  for (std::size_t leg = 0; leg < line.legCount(); ++leg) {
    const Point ends[] = {line.vertices()[leg], line.vertices()[leg + 1]};
    const Box around = grown(boxAround(ends), reach + Metres{0.001});
    if (std::any_of(places.begin(), places.end(), [&](const Box& place) { return meet(around, place); })) return true;
  }
  return false;
}

Faults checkRouteTags(const Context& context, const floor::Route& route) {
  Faults faults;
  // Without any tag at all that is told once, for the site.
  if (context.plan.laid().empty() && context.site.looseTags.empty()) return faults;
  const auto place = route.vertices.empty() ? Box{} : boxAround(route.vertices);
  if (!isPlace(place)) return faults;
  const Polyline line{withoutRepeats(route.vertices, false)};
  for (const floor::VehicleSetup* vehicle : readerRowsOf(context.site)) {
    if (vehicle->readers.empty() || line.legCount() == 0) continue;
    const Sighted blind = longestBlind(Sight{context, *vehicle}.along(line), line.length().value());
    const Metres length{blind.to - blind.from};
    if (length <= context.options.longestBlind) continue;
    faults.push_back(
        {FaultKind::RouteWithoutTags,
         Severity::Warning,
         phrase("Core", "On route \"%1\" %2 sees no registered tag for %3 m, from %4 m on; it can bridge %5 m.")
             .with(route.name, nameOf(*vehicle), inMetres(length), placeText(line.at(Metres{blind.from})),
                   inMetres(context.options.longestBlind)),
         boxOfWay(line, blind),
         {{ObjectKind::Route, route.name}},
         {}});
    addTo(faults.back().objects, *vehicle);
  }
  return faults;
}

}  // namespace tessera::sitecheck
