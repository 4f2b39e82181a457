// LIF to routes and zones.
#include <algorithm>
#include <map>
#include <set>

#include "exchange/lif.h"
#include "exchange/lif_chains.h"
#include "exchange/lif_speeds.h"
#include "floor/json_node.h"
#include "floor/route_legs.h"
#include "floor/site_names.h"

namespace tessera::exchange {
namespace {

using floor::JsonNode;
using floor::Site;
using floor::ZoneKind;

constexpr std::size_t kMostItems = 100'000;  // nodes, edges, stations
constexpr std::size_t kMostOfSite = 10'000;  // zones, routes, vertices: as a site file allows
constexpr std::size_t kLongText = 10'000;

struct Station {
  std::string name;
  ZoneKind kind;
  Point place;
};

class LifReader {
public:
  void read(const JsonNode& root) {
    root.objectWith({"metaInformation", "layouts"});
    const JsonNode meta = root["metaInformation"];
    meta.objectWith({"projectIdentification", "creator", "exportTimestamp", "lifVersion"});
    const std::string version = meta["lifVersion"].text(1, kLongText);
    if (!meta.failed() && version.rfind("1.", 0) != 0 && version != "1")
      meta["lifVersion"].fail(phrase("Core", "a version 1.x of LIF"));
    const std::size_t layouts = root["layouts"].array(0, kMostItems);
    // An edge may end in another layout: all nodes come first.
    for (std::size_t i = 0; i < layouts && !root.failed(); ++i) nodes(root["layouts"][i]);
    for (std::size_t i = 0; i < layouts && !root.failed(); ++i) rest(root["layouts"][i], i);
    if (layouts > 1)
      notes.push_back(
          phrase("Core", "The file has several layouts, which are laid upon one another: %1.").with(layouts));
  }
  void conclude() {
    tell(actions_, phrase("Core", "Nodes and edges whose actions were left out: %1."));
    tell(curves_, phrase("Core", "Curved edges that became straight legs: %1."));
    tell(restrictions_, phrase("Core", "Edges whose load and height restrictions were left out: %1."));
    tell(levels_, phrase("Core", "Edges to another layout, left out: %1."));
    tell(stations.size(),
         phrase("Core", "LIF says only where a station is; stations read as zones of 0.6 × 0.6 m: %1."));
  }

  std::vector<std::string> nodeIds;
  std::vector<Point> places;
  std::vector<LifEdge> edges;
  std::vector<TypeSpeeds> speeds;  ///< of each edge
  std::vector<Station> stations;
  std::vector<Sentence> notes;

private:
  void tell(std::size_t count, const Pattern& pattern) {
    if (count > 0) notes.push_back(pattern.with(count));
  }
  static Point position(const JsonNode& n) {
    n.objectWith({"x", "y"});
    return {Metres{n["x"].number(-100'000, 100'000, phrase("Core", "metres"))},
            Metres{n["y"].number(-100'000, 100'000, phrase("Core", "metres"))}};
  }
  static std::string optionalText(const JsonNode& n) { return n.present() ? n.text(0, kLongText) : std::string{}; }

  void nodes(const JsonNode& layout) {
    layout.objectWith({"layoutId", "layoutVersion", "nodes", "edges", "stations"});
    const std::size_t layoutNumber = layoutsRead_++;
    const JsonNode list = layout["nodes"];  // named: what is taken from it looks back to it
    const std::size_t count = list.array(0, kMostItems);
    for (std::size_t i = 0; i < count && !layout.failed(); ++i) {
      const JsonNode n = list[i];
      n.objectWith({"nodeId", "nodePosition", "vehicleTypeNodeProperties"});
      const std::string id = n["nodeId"].text(1, 200);
      const Point place = position(n["nodePosition"]);
      if (n.failed()) return;
      if (!index_.try_emplace(id, nodeIds.size()).second)
        return n["nodeId"].fail(phrase("Core", "a nodeId that no other node has"));
      nodeIds.push_back(id);
      places.push_back(place);
      layoutOf_.push_back(layoutNumber);
      if (anyOf(n["vehicleTypeNodeProperties"], {"actions"})) ++actions_;
    }
  }

  // Whether any element of the array has one of the keys.
  static bool anyOf(const JsonNode& list, std::initializer_list<std::string_view> keys) {
    const std::size_t count = list.array(0, kMostItems);
    for (std::size_t i = 0; i < count && !list.failed(); ++i)
      for (const std::string_view key : keys)
        if (list[i][key].present()) return true;
    return false;
  }

  static TypeSpeeds speedsOf(const JsonNode& properties) {
    TypeSpeeds all;
    const std::size_t count = properties.array(0, kMostItems);
    for (std::size_t i = 0; i < count && !properties.failed(); ++i) {
      const JsonNode p = properties[i];
      if (!p["maxSpeed"].present() || p["maxSpeed"].isNull()) continue;
      all.emplace_back(optionalText(p["vehicleTypeId"]), MetresPerSecond{p["maxSpeed"].number(0.0, 1e6, "m/s")});
    }
    return all;
  }

  std::optional<std::size_t> nodeNamed(const JsonNode& n) {
    const std::string id = n.text(1, 200);
    if (n.failed()) return std::nullopt;
    const auto found = index_.find(id);
    if (found != index_.end()) return found->second;
    n.fail(phrase("Core", "the nodeId of a node of this file"));
    return std::nullopt;
  }

  void rest(const JsonNode& layout, std::size_t number) {
    const JsonNode list = layout["edges"];  // named: what is taken from it looks back to it
    const std::size_t edgeCount = list.array(0, kMostItems);
    for (std::size_t i = 0; i < edgeCount && !layout.failed(); ++i) {
      const JsonNode e = list[i];
      e.objectWith({"edgeId", "startNodeId", "endNodeId", "vehicleTypeEdgeProperties"});
      const auto from = nodeNamed(e["startNodeId"]);
      const auto to = nodeNamed(e["endNodeId"]);
      if (!from || !to) return;
      const JsonNode properties = e["vehicleTypeEdgeProperties"];
      actions_ += anyOf(properties, {"actions"}) ? 1 : 0;
      curves_ += anyOf(properties, {"trajectory"}) ? 1 : 0;
      restrictions_ += anyOf(properties, {"loadRestriction", "minHeight", "maxHeight"}) ? 1 : 0;
      if (layoutOf_[*from] != number || layoutOf_[*to] != number) {
        ++levels_;
        continue;
      }
      edges.push_back({e["edgeId"].text(1, 250), optionalText(e["edgeName"]), *from, *to});
      speeds.push_back(speedsOf(properties));
    }
    const std::size_t stationCount = layout["stations"].array(0, kMostItems);
    for (std::size_t i = 0; i < stationCount && !layout.failed(); ++i) station(layout["stations"][i]);
  }

  void station(const JsonNode& s) {
    s.objectWith({"stationId", "interactionNodeIds"});
    const std::string id = s["stationId"].text(1, 200);
    const std::string name = optionalText(s["stationName"]);
    const JsonNode at = s["interactionNodeIds"];
    if (at.array(1, kMostItems) == 0) return;
    const auto node = nodeNamed(at[0]);
    if (!node) return;
    const Point place = s["stationPosition"].present() ? position(s["stationPosition"]) : places[*node];
    // Our own exports say the kind; whatever else stands there, a station is where loads are.
    const std::string description = optionalText(s["stationDescription"]);
    ZoneKind kind = ZoneKind::Storage;
    for (const ZoneKind k : {ZoneKind::Parking, ZoneKind::Charging})
      if (description == floor::kZoneKindNames.at(static_cast<std::size_t>(k))) kind = k;
    stations.push_back({shortened(name.empty() ? id : name, 200), kind, place});
  }

  std::map<std::string, std::size_t> index_;
  std::vector<std::size_t> layoutOf_;
  std::size_t layoutsRead_ = 0;
  std::size_t actions_ = 0;
  std::size_t curves_ = 0;
  std::size_t restrictions_ = 0;
  std::size_t levels_ = 0;
};

// Gives the number of legs that took a speed over.
std::size_t addRoutes(const LifReader& lif, Site& site) {
  const LegSpeedFinder finder{site, lif.speeds};
  std::size_t taken = 0;
  for (Chain& chain : chainsOf(lif.edges, lif.nodeIds)) {
    floor::Route route;
    route.name = std::move(chain.name);
    for (const std::size_t node : chain.nodes) route.vertices.push_back(lif.places[node]);
    const auto same = std::find_if(site.routes.begin(), site.routes.end(),
                                   [&](const floor::Route& r) { return r.name == route.name; });
    const bool known = same != site.routes.end() && same->vertices == route.vertices;
    for (std::size_t leg = 0; leg < chain.edges.size(); ++leg) {
      const auto before = known ? floor::legSpeed(*same, leg) : std::nullopt;
      const auto speed =
          finder.find(lif.speeds[chain.edges[leg]], route.vertices[leg], route.vertices[leg + 1], before);
      route.legSpeeds.push_back(speed);
      taken += speed && speed != before ? 1 : 0;
    }
    tidyLegSpeeds(route);
    if (same == site.routes.end()) {
      site.routes.push_back(std::move(route));
    } else {
      same->vertices = std::move(route.vertices);
      same->legSpeeds = std::move(route.legSpeeds);
    }
  }
  return taken;
}

void addZones(const LifReader& lif, Site& site) {
  std::set<std::string> names;
  for (const floor::Zone& zone : site.zones) names.insert(zone.name);
  const Metres half = 0.5 * kStationSide;
  for (const Station& s : lif.stations) {
    if (!names.insert(s.name).second) continue;
    const Box box{s.place - Offset{half, half}, s.place + Offset{half, half}};
    site.zones.push_back(
        {s.name, s.kind, {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}}, {}, {}});
  }
}

}  // namespace

Result<Preview> importLif(const Site& onto, std::string_view text, const std::string& name) {
  LifReader lif;
  if (auto read = floor::readDocument(text, name, phrase("Core", "a LIF layout"),
                                      [&lif](const JsonNode& root) { lif.read(root); });
      !read)
    return tl::unexpected{std::move(read.error())};
  lif.conclude();
  Preview preview{onto, {}, std::move(lif.notes)};
  if (const std::size_t taken = addRoutes(lif, preview.site); taken > 0)
    preview.notes.push_back(phrase("Core", "Highest speeds of edges that became those of legs: %1.").with(taken));
  addZones(lif, preview.site);
  const auto tooLong = [](const floor::Route& r) { return r.vertices.size() > kMostOfSite; };
  if (preview.site.routes.size() > kMostOfSite || preview.site.zones.size() > kMostOfSite ||
      std::any_of(preview.site.routes.begin(), preview.site.routes.end(), tooLong))
    return failure(
        phrase("Core", "%1: the site would have more than 10 000 routes, zones or points of a route.").with(name));
  preview.changes = sitediff::difference(onto, preview.site);
  return preview;
}

}  // namespace tessera::exchange
