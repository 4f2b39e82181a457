// A site out of its tables.
#include <algorithm>
#include <span>
#include <utility>

#include "floor/route_legs.h"
#include "floor/site_names.h"
#include "store/site_store.h"
#include "store/transaction.h"

namespace tessera::store {
namespace {

class Loader {
public:
  Loader(Transaction& transaction, qint64 site) : transaction_{transaction}, site_{site} {}

  void load(floor::Site& site) {
    each(
        "SELECT name, width, height, pitch, margin_x, margin_y, columns, rows, pattern, starts_with_gap, custom"
        " FROM tile_type WHERE site=? ORDER BY nr",
        [&](const Statement& row) { site.tileTypes.push_back(tileType(row)); });
    each("SELECT serial, type FROM tile WHERE site=? ORDER BY nr", [&](const Statement& row) {
      site.tiles.push_back({row.text(0), row.text(1), {}});
    });
    each("SELECT tile, uid FROM tag WHERE site=? ORDER BY tile, nr", [&](const Statement& row) {
      if (auto* tile = owner(row, site.tiles)) tile->uids.push_back(row.isNull(1) ? floor::TagUid{} : uid(row, 1));
    });
    each("SELECT serial, x, y, quarter_turns FROM placement WHERE site=? ORDER BY nr", [&](const Statement& row) {
      site.placements.push_back({row.text(0), point(row, 1), static_cast<int>(row.whole(3))});
    });
    each("SELECT uid, x, y FROM loose_tag WHERE site=? ORDER BY nr", [&](const Statement& row) {
      site.looseTags.push_back({row.isNull(0) ? floor::TagUid{} : uid(row, 0), point(row, 1)});
    });
    each("SELECT name, kind, speed, direction FROM zone WHERE site=? ORDER BY nr",
         [&](const Statement& row) { site.zones.push_back(zone(row)); });
    each("SELECT zone, x, y FROM zone_point WHERE site=? ORDER BY zone, nr", [&](const Statement& row) {
      if (auto* zone = owner(row, site.zones)) zone->outline.push_back(point(row, 1));
    });
    each("SELECT name, control_spacing FROM route WHERE site=? ORDER BY nr", [&](const Statement& row) {
      site.routes.push_back({row.text(0), {}, Metres{row.number(1)}});
    });
    each("SELECT route, x, y, leg_speed FROM route_vertex WHERE site=? ORDER BY route, nr", [&](const Statement& row) {
      if (auto* route = owner(row, site.routes)) vertex(row, *route);
    });
    for (floor::Route& route : site.routes) tidyLegSpeeds(route);
    each(
        "SELECT id, name, key, reader_radius, track, wheel_diameter, max_speed, max_turn_rate, acceleration, start_x,"
        " start_y, start_heading, corner_cut FROM vehicle WHERE site=? ORDER BY nr",
        [&](const Statement& row) { site.vehicles.push_back(vehicle(row)); });
    each("SELECT vehicle, x, y FROM vehicle_reader WHERE site=? ORDER BY vehicle, nr", [&](const Statement& row) {
      if (auto* vehicle = owner(row, site.vehicles)) vehicle->readers.push_back(offset(row, 1));
    });
    each("SELECT vehicle, x, y FROM vehicle_footprint WHERE site=? ORDER BY vehicle, nr", [&](const Statement& row) {
      if (auto* vehicle = owner(row, site.vehicles)) vehicle->footprint.push_back(point(row, 1));
    });
    each("SELECT file, x, y, pixel, turn, opacity FROM backdrop WHERE site=?",
         [&](const Statement& row) { site.backdrop = backdrop(row); });
    each("SELECT picture FROM backdrop_picture WHERE site=?", [&](const Statement& row) {
      if (!site.backdrop) return transaction_.failDamaged();
      site.backdrop->picture = std::make_shared<const std::string>(row.value(0).toByteArray().toStdString());
    });
  }

private:
  template <class Take>
  void each(const char* sql, Take take) {
    Statement rows{transaction_, QLatin1String{sql}};
    rows.run({site_});
    while (rows.next()) take(std::as_const(rows));
  }
  /// The item whose number stands in the first column.
  template <class Items>
  typename Items::value_type* owner(const Statement& row, Items& items) {
    const qint64 nr = row.whole(0);
    if (nr >= 0 && nr < static_cast<qint64>(items.size())) return &items[static_cast<std::size_t>(nr)];
    transaction_.failDamaged();
    return nullptr;
  }
  template <class Names>
  std::size_t choice(const std::string& word, const Names& names) {
    const auto found = std::find(names.begin(), names.end(), word);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    transaction_.failDamaged();
    return 0;
  }
  static Point point(const Statement& row, int at) { return {Metres{row.number(at)}, Metres{row.number(at + 1)}}; }
  static Offset offset(const Statement& row, int at) { return {Metres{row.number(at)}, Metres{row.number(at + 1)}}; }
  static std::span<const std::uint8_t> view(const QByteArray& bytes) {
    return {reinterpret_cast<const std::uint8_t*>(bytes.constData()), static_cast<std::size_t>(bytes.size())};
  }
  floor::TagUid uid(const Statement& row, int at) {
    const QByteArray bytes = row.value(at).toByteArray();
    if (const auto uid = floor::TagUid::fromBytes(view(bytes))) return *uid;
    transaction_.failDamaged();
    return {};
  }

  floor::TileType tileType(const Statement& row) {
    floor::TileType type;
    type.name = row.text(0);
    type.width = Metres{row.number(1)};
    type.height = Metres{row.number(2)};
    type.pitch = Metres{row.number(3)};
    type.margin = offset(row, 4);
    type.columns = static_cast<int>(row.whole(6));
    type.rows = static_cast<int>(row.whole(7));
    type.pattern = static_cast<floor::Pattern>(choice(row.text(8), floor::kPatternNames));
    type.startsWithGap = row.whole(9) != 0;
    for (const char place : row.text(10)) type.custom.push_back(place == '#');
    return type;
  }
  floor::Zone zone(const Statement& row) {
    floor::Zone zone;
    zone.name = row.text(0);
    zone.kind = static_cast<floor::ZoneKind>(choice(row.text(1), floor::kZoneKindNames));
    if (!row.isNull(2)) zone.speed = MetresPerSecond{row.number(2)};
    if (!row.isNull(3)) zone.direction = Radians{row.number(3)};
    return zone;
  }
  static floor::Backdrop backdrop(const Statement& row) {
    return {row.text(0), nullptr, point(row, 1), Metres{row.number(3)}, Radians{row.number(4)}, row.number(5)};
  }
  static void vertex(const Statement& row, floor::Route& route) {
    route.vertices.push_back(point(row, 1));
    route.legSpeeds.push_back(row.isNull(3) ? std::nullopt : std::optional{MetresPerSecond{row.number(3)}});
  }
  floor::VehicleSetup vehicle(const Statement& row) {
    floor::VehicleSetup vehicle;
    vehicle.id.value = static_cast<std::uint8_t>(row.whole(0));
    vehicle.name = row.text(1);
    const QByteArray key = row.value(2).toByteArray();
    if (view(key).size() == vehicle.key.size())
      std::copy(view(key).begin(), view(key).end(), vehicle.key.begin());
    else
      transaction_.failDamaged();
    vehicle.readerRadius = Metres{row.number(3)};
    vehicle.track = Metres{row.number(4)};
    vehicle.wheelDiameter = Metres{row.number(5)};
    vehicle.maxSpeed = MetresPerSecond{row.number(6)};
    vehicle.maxTurnRate = RadiansPerSecond{row.number(7)};
    vehicle.acceleration = MetresPerSecond2{row.number(8)};
    vehicle.cornerCut = Metres{row.number(12)};
    if (!row.isNull(9)) vehicle.start = Pose{point(row, 9), Radians{row.number(11)}};
    return vehicle;
  }

  Transaction& transaction_;
  qint64 site_;
};

}  // namespace

Result<std::optional<floor::Site>> SiteStore::load(const std::string& key) const {
  Transaction reading{database_, Transaction::Kind::Read};
  std::optional<floor::Site> site;
  {
    Statement head{reading,
                   QStringLiteral("SELECT id, name, north_to_y, channel, air_rate, baud FROM site WHERE key=?")};
    head.run({toText(key)});
    if (head.next()) {
      site.emplace();
      site->name = head.text(1);
      site->northToY = Radians{head.number(2)};
      site->radio = {static_cast<int>(head.whole(3)), head.number(4), static_cast<int>(head.whole(5))};
      Loader{reading, head.whole(0)}.load(*site);
    }
  }
  if (auto done = reading.commit(); !done) return tl::unexpected{done.error()};
  return site;
}

}  // namespace tessera::store
