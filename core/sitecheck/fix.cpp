#include "sitecheck/fix.h"

#include <algorithm>

#include "floor/route_legs.h"

namespace tessera::sitecheck {
namespace {

// The last of the items that is so; of two alike the later one is the one too many.
template <class Items, class Is>
auto lastWhere(Items& items, Is is) {
  const auto found = std::find_if(items.rbegin(), items.rend(), is);
  return found == items.rend() ? nullptr : &*found;
}

template <class Items, class Item>
bool eraseLast(Items& items, const Item& item) {
  const auto found = std::find(items.rbegin(), items.rend(), item);
  if (found == items.rend()) return false;
  items.erase(std::next(found).base());
  return true;
}

struct Applier {
  floor::Site& site;

  bool operator()(const MoveTile& e) const {
    floor::Placement* p = lastWhere(site.placements, [&](const floor::Placement& x) { return x == e.before; });
    if (p != nullptr) p->origin = e.origin;
    return p != nullptr;
  }
  bool operator()(const TakeTileUp& e) const { return eraseLast(site.placements, e.placement); }
  bool operator()(const ForgetTile& e) const {
    return std::count(site.tiles.begin(), site.tiles.end(), e.tile) > 1 && eraseLast(site.tiles, e.tile);
  }
  bool operator()(const RenameTile& e) const {
    const auto called = [&](const std::string& serial) {
      return std::count_if(site.tiles.begin(), site.tiles.end(),
                           [&](const floor::Tile& t) { return t.serial == serial; });
    };
    floor::Tile* tile = lastWhere(site.tiles, [&](const floor::Tile& t) { return t == e.tile; });
    if (tile == nullptr || called(e.tile.serial) < 2 || called(e.serial) > 0) return false;
    tile->serial = e.serial;
    return true;
  }
  bool operator()(const DropUids& e) const {
    floor::Tile* tile = lastWhere(site.tiles, [&](const floor::Tile& t) { return t == e.tile; });
    if (tile == nullptr || e.keep >= tile->uids.size()) return false;
    tile->uids.resize(e.keep);
    return true;
  }
  bool operator()(const ForgetTileType& e) const {
    return std::count(site.tileTypes.begin(), site.tileTypes.end(), e.type) > 1 && eraseLast(site.tileTypes, e.type);
  }
  bool operator()(const ClearUid& e) const {
    floor::Tile* tile = lastWhere(site.tiles, [&](const floor::Tile& t) {
      return t.serial == e.serial && e.position < t.uids.size() && t.uids[e.position] == e.uid;
    });
    if (tile != nullptr) tile->uids[e.position] = {};
    return tile != nullptr;
  }
  bool operator()(const ForgetLooseTag& e) const { return eraseLast(site.looseTags, e.tag); }
  bool operator()(const ReplaceOutline& e) const {
    floor::Zone* zone =
        lastWhere(site.zones, [&](const floor::Zone& z) { return z.name == e.zone && z.outline == e.before; });
    if (zone != nullptr) zone->outline = e.after;
    return zone != nullptr;
  }
  bool operator()(const ReplaceVertices& e) const {
    floor::Route* route =
        lastWhere(site.routes, [&](const floor::Route& r) { return r.name == e.route && r.vertices == e.before; });
    if (route != nullptr) keepVertices(*route, e.after);
    return route != nullptr;
  }
  bool operator()(const SetLegSpeed& e) const {
    floor::Route* route = lastWhere(site.routes, [&](const floor::Route& r) {
      return r.name == e.route && floor::legSpeed(r, e.leg) == e.before && e.leg < floor::legCount(r);
    });
    if (route != nullptr) setLegSpeed(*route, e.leg, e.after);
    return route != nullptr;
  }
  bool operator()(const SetLegSpeeds& e) const {
    floor::Route* route = lastWhere(site.routes, [&](const floor::Route& r) { return r == e.before; });
    if (route != nullptr) {
      route->legSpeeds = e.after;
      tidyLegSpeeds(*route);
    }
    return route != nullptr;
  }
  bool operator()(const MoveVertices& e) const {
    floor::Route* route =
        lastWhere(site.routes, [&](const floor::Route& r) { return r.name == e.route && r.vertices == e.before; });
    if (route != nullptr) route->vertices = e.after;
    return route != nullptr;
  }
  bool operator()(const ReverseRoute& e) const {
    floor::Route* route = lastWhere(site.routes, [&](const floor::Route& r) { return r == e.before; });
    if (route != nullptr) reverse(*route);
    return route != nullptr;
  }
  bool operator()(const GiveAddress& e) const {
    floor::VehicleSetup* v = lastWhere(site.vehicles, [&](const floor::VehicleSetup& x) { return x == e.vehicle; });
    if (v != nullptr) v->id = e.id;
    return v != nullptr;
  }
};

}  // namespace

bool mend(const Edit& edit, floor::Site& site) { return std::visit(Applier{site}, edit); }

}  // namespace tessera::sitecheck
