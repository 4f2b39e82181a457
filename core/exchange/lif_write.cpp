// Site to LIF.
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "exchange/lif.h"
#include "exchange/lif_speeds.h"
#include "floor/route_legs.h"
#include "floor/site_names.h"
#include "region/region.h"

namespace tessera::exchange {
namespace {

using floor::Site;
using floor::Zone;
using floor::ZoneKind;
using nlohmann::ordered_json;

bool isStation(const Zone& zone) {
  return zone.kind == ZoneKind::Parking || zone.kind == ZoneKind::Charging || zone.kind == ZoneKind::Storage;
}

class LifWriter {
public:
  explicit LifWriter(const Site& site) : site_{site}, types_{vehicleTypes(site)}, speeds_{site} {}

  ordered_json layout() {
    ordered_json edges = ordered_json::array();
    for (const floor::Route& route : site_.routes) {
      for (std::size_t i = 0; i + 1 < route.vertices.size(); ++i) {
        ordered_json edge;
        edge["edgeId"] = route.name + "/" + std::to_string(i + 1);
        edge["edgeName"] = route.name;
        edge["startNodeId"] = node(route.vertices[i]);
        edge["endNodeId"] = node(route.vertices[i + 1]);
        edge["vehicleTypeEdgeProperties"] = edgeProperties(route, i);
        edges.push_back(std::move(edge));
      }
    }
    ordered_json stations = ordered_json::array();
    for (const Zone& zone : site_.zones)
      if (isStation(zone) && !zone.outline.empty()) stations.push_back(station(zone));
    ordered_json layout;
    layout["layoutId"] = site_.name;
    layout["layoutName"] = site_.name;
    layout["layoutVersion"] = "1";
    layout["nodes"] = std::move(nodes_);
    layout["edges"] = std::move(edges);
    layout["stations"] = std::move(stations);
    return layout;
  }

private:
  std::string node(Point place) {
    const auto [known, isNew] = ids_.try_emplace({place.x, place.y}, "N" + std::to_string(ids_.size() + 1));
    if (isNew) {
      ordered_json n;
      n["nodeId"] = known->second;
      n["nodePosition"] = {{"x", place.x.value()}, {"y", place.y.value()}};
      n["vehicleTypeNodeProperties"] = ordered_json::array();
      for (const VehicleType& type : types_) n["vehicleTypeNodeProperties"].push_back({{"vehicleTypeId", type.id}});
      nodes_.push_back(std::move(n));
      places_.push_back(place);
    }
    return known->second;
  }

  // Turns are made at the nodes.
  [[nodiscard]] ordered_json edgeProperties(const floor::Route& route, std::size_t leg) const {
    ordered_json all = ordered_json::array();
    for (const VehicleType& type : types_) {
      ordered_json p;
      p["vehicleTypeId"] = type.id;
      p["vehicleOrientation"] = 0.0;
      p["orientationType"] = "TANGENTIAL";
      p["rotationAllowed"] = false;
      p["rotationAtStartNodeAllowed"] = "BOTH";
      p["rotationAtEndNodeAllowed"] = "BOTH";
      p["maxSpeed"] =
          speeds_.of(type.vehicle->maxSpeed, route.vertices[leg], route.vertices[leg + 1], floor::legSpeed(route, leg))
              .value();
      p["maxRotationSpeed"] = type.vehicle->maxTurnRate.value();
      all.push_back(std::move(p));
    }
    return all;
  }

  ordered_json station(const Zone& zone) {
    const region::Region area = region::Region::of(zone.outline);
    const Point middle = middleOf(boxAround(zone.outline));
    const Point place = area.contains(middle) ? middle : zone.outline.front();
    ordered_json interaction = ordered_json::array();
    for (const Point p : places_)
      if (area.contains(p)) interaction.push_back(ids_.at({p.x, p.y}));
    if (interaction.empty()) interaction.push_back(node(place));
    std::string id = zone.name;
    for (int n = 2; !stationIds_.insert(id).second; ++n) id = zone.name + " (" + std::to_string(n) + ")";
    ordered_json s;
    s["stationId"] = id;
    s["interactionNodeIds"] = std::move(interaction);
    s["stationName"] = zone.name;
    s["stationDescription"] = floor::kZoneKindNames.at(static_cast<std::size_t>(zone.kind));
    s["stationPosition"] = {{"x", place.x.value()}, {"y", place.y.value()}};
    return s;
  }

  const Site& site_;
  std::vector<VehicleType> types_;
  EdgeSpeeds speeds_;
  std::map<std::pair<Metres, Metres>, std::string> ids_;
  std::vector<Point> places_;
  ordered_json nodes_ = ordered_json::array();
  std::set<std::string> stationIds_;
};

std::vector<Sentence> leftOut(const Site& site) {
  std::vector<Sentence> notes;
  const auto tell = [&notes](std::size_t count, const Pattern& pattern) {
    if (count > 0) notes.push_back(pattern.with(count));
  };
  tell(site.tiles.size(), phrase("Core", "LIF carries no tiles; left out, with their tags: %1."));
  tell(site.looseTags.size(), phrase("Core", "LIF carries no tags; loose ones left out: %1."));
  const auto stations = static_cast<std::size_t>(std::count_if(site.zones.begin(), site.zones.end(), isStation));
  tell(stations, phrase("Core", "Of parking, charging and storage zones only the middle is kept, as stations: %1."));
  tell(site.zones.size() - stations,
       phrase("Core",
              "Zones of other kinds are left out; slow zones stay as the highest speed of the edges in them: %1."));
  tell(site.vehicles.size(), phrase("Core", "Of vehicles only the highest speeds are kept, as types: %1."));
  const auto spaced =
      static_cast<std::size_t>(std::count_if(site.routes.begin(), site.routes.end(), [](const floor::Route& r) {
        return r.controlSpacing != floor::Route{}.controlSpacing;
      }));
  if (site.backdrop) notes.emplace_back(phrase("Core", "LIF carries no picture of the floor plan; left out."));
  tell(spaced, phrase("Core", "Distances of control points are left out; routes concerned: %1."));
  return notes;
}

}  // namespace

LifText writeLif(const Site& site, const std::string& timestamp) {
  ordered_json lif;
  lif["metaInformation"] = {{"projectIdentification", site.name},
                            {"creator", "Tessera"},
                            {"exportTimestamp", timestamp},
                            {"lifVersion", "1.0.0"}};
  lif["layouts"] = ordered_json::array({LifWriter{site}.layout()});
  return {lif.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n", leftOut(site)};
}

}  // namespace tessera::exchange
