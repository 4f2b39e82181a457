// *.tessera.json to Site.
#include <algorithm>
#include <array>

#include "floor/json_node.h"
#include "floor/picture.h"
#include "floor/route_legs.h"
#include "floor/site_json.h"
#include "floor/site_names.h"

namespace tessera::floor {
namespace {

constexpr std::size_t kMaxName = 200;
constexpr std::size_t kMany = kMostTiles;
constexpr std::size_t kSome = kMostRoutes;
constexpr double kFar = 100'000.0;

Metres readMetres(const JsonNode& n, double low, double high) {
  return Metres{n.number(low, high, phrase("Core", "metres"))};
}
Metres readCoordinate(const JsonNode& n) { return readMetres(n, -kFar, kFar); }
Radians readDegrees(const JsonNode& n) { return fromDegrees(n.number(-360.0, 360.0, phrase("Core", "degrees"))); }

Point readPoint(const JsonNode& n) {
  static_cast<void>(n.array(2, 2));
  return {readCoordinate(n[0]), readCoordinate(n[1])};
}

Offset readOffset(const JsonNode& n) {
  const Point p = readPoint(n);
  return {p.x, p.y};
}

Point readXY(const JsonNode& n) { return {readCoordinate(n["x_m"]), readCoordinate(n["y_m"])}; }

TagUid readUid(const JsonNode& n, bool mayBeNull) {
  if (mayBeNull && n.isNull()) return {};
  const std::string text = n.text(0, kMaxName);
  const auto uid = TagUid::parse(text);
  // Files hold the plain form only: one UID, one text.
  if (!n.failed() && uid && uid->text().size() == text.size()) return *uid;
  n.fail(mayBeNull ? phrase("Core", "a tag's UID of 8, 14 or 20 hexadecimal digits or null")
                   : phrase("Core", "a tag's UID of 8, 14 or 20 hexadecimal digits"));
  return {};
}

wire::Key readKey(const JsonNode& n) {
  const std::string text = n.text(0, kMaxName);
  wire::Key key{};
  const bool good = text.size() == 2 * key.size() && std::all_of(text.begin(), text.end(), [](char c) {
                      return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
                    });
  // A key is a secret: the error does not quote it.
  if (!good && !n.failed()) n.secretFail(phrase("Core", "a key of 32 hexadecimal digits"));
  for (std::size_t i = 0; good && i < key.size(); ++i) {
    key[i] = static_cast<std::uint8_t>(std::stoul(text.substr(2 * i, 2), nullptr, 16));
  }
  return key;
}

// Rows of '#' (a tag) and '.' (none), the lowest row first, as many and as long as the lattice.
std::vector<bool> readCustom(const JsonNode& n, int columns, int rows) {
  std::vector<bool> places;
  const auto height = static_cast<std::size_t>(rows);
  const auto width = static_cast<std::size_t>(columns);
  for (std::size_t row = 0; row < n.array(height, height); ++row) {
    const std::string line = n[row].text(width, width);
    if (line.find_first_not_of("#.") != std::string::npos) n[row].fail(phrase("Core", "a row of '#' and '.'"));
    for (char c : line) places.push_back(c == '#');
  }
  return places;
}

TileType readType(JsonNode n) {
  n.object({"name", "width_m", "height_m", "pitch_m", "columns", "rows", "pattern"},
           {"margin_m", "starts_with_gap", "custom"});
  TileType type;
  type.name = n["name"].text(1, kMaxName);
  type.width = readMetres(n["width_m"], 0.01, 100.0);
  type.height = readMetres(n["height_m"], 0.01, 100.0);
  type.pitch = readMetres(n["pitch_m"], 0.001, 100.0);
  type.columns = n["columns"].integer(1, 100);
  type.rows = n["rows"].integer(1, 100);
  type.pattern = static_cast<Pattern>(n["pattern"].choice({kPatternNames.begin(), kPatternNames.end()}));
  type.margin = n["margin_m"].present() ? readOffset(n["margin_m"]) : Offset{type.pitch / 2.0, type.pitch / 2.0};
  if (n["starts_with_gap"].present()) type.startsWithGap = n["starts_with_gap"].boolean();
  if (n.failed()) return type;
  if (type.startsWithGap && type.pattern != Pattern::OneInTwo)
    n["starts_with_gap"].fail(phrase("Core", "no gap at the start of a pattern that is not one-in-two"));
  if ((type.pattern == Pattern::Custom) != n["custom"].present())
    n["custom"].fail(n["custom"].present()
                         ? phrase("Core", "the custom pattern's rows only with \"pattern\": \"custom\"")
                         : phrase("Core", "the rows of the custom pattern"));
  if (type.pattern == Pattern::Custom) type.custom = readCustom(n["custom"], type.columns, type.rows);
  constexpr Metres slack{1e-6};
  const bool onTile = type.margin.x >= -slack && type.margin.y >= -slack &&
                      type.margin.x + (type.columns - 1) * type.pitch <= type.width + slack &&
                      type.margin.y + (type.rows - 1) * type.pitch <= type.height + slack;
  if (!onTile) n["pitch_m"].fail(phrase("Core", "a lattice of columns and rows that lies on the tile"));
  return type;
}

Tile readTile(JsonNode n) {
  n.object({"serial", "type", "uids"});
  Tile tile;
  tile.serial = n["serial"].text(1, kMaxName);
  tile.type = n["type"].text(1, kMaxName);
  tile.uids = n["uids"].list(0, kSome, [](const JsonNode& uid) { return readUid(uid, true); });
  return tile;
}

Placement readPlacement(JsonNode n) {
  n.object({"serial", "x_m", "y_m"}, {"quarter_turns"});
  const auto turns = n["quarter_turns"];
  return {n["serial"].text(1, kMaxName), readXY(n), turns.present() ? turns.integer(0, 3) : 0};
}

LooseTag readLooseTag(JsonNode n) {
  n.object({"uid", "x_m", "y_m"});
  return {readUid(n["uid"], false), readXY(n)};
}

Zone readZone(JsonNode n) {
  n.object({"name", "kind", "outline_m"}, {"speed_mps", "direction_deg"});
  Zone zone;
  zone.name = n["name"].text(1, kMaxName);
  zone.kind = static_cast<ZoneKind>(n["kind"].choice({kZoneKindNames.begin(), kZoneKindNames.end()}));
  zone.outline = n["outline_m"].list(3, kSome, readPoint);
  if (n["speed_mps"].present()) zone.speed = MetresPerSecond{n["speed_mps"].number(0.001, 20.0, "m/s")};
  if (n["direction_deg"].present()) zone.direction = readDegrees(n["direction_deg"]);
  return zone;
}

std::optional<MetresPerSecond> readLegSpeed(const JsonNode& n) {
  if (n.isNull()) return std::nullopt;
  return MetresPerSecond{n.number(kLeastLegSpeed.value(), kMostLegSpeed.value(), "m/s")};
}

Route readRoute(JsonNode n) {
  n.object({"name", "vertices_m"}, {"control_spacing_m", "leg_speeds_mps"});
  Route route;
  route.name = n["name"].text(1, kMaxName);
  route.vertices = n["vertices_m"].list(2, kSome, readPoint);
  if (n["control_spacing_m"].present()) route.controlSpacing = readMetres(n["control_spacing_m"], 0.01, 10.0);
  if (const JsonNode speeds = n["leg_speeds_mps"]; speeds.present()) {
    route.legSpeeds = speeds.list(1, kSome, readLegSpeed);
    if (!n.failed() && route.legSpeeds.size() != legCount(route))
      speeds.fail(phrase("Core", "a speed or null for each leg, one fewer than vertices"));
    tidyLegSpeeds(route);
  }
  return route;
}

VehicleSetup readVehicle(JsonNode n) {
  n.object({"id", "name", "key", "readers_m", "footprint_m"},
           {"reader_radius_m", "track_m", "wheel_diameter_m", "max_speed_mps", "max_turn_rate_radps",
            "acceleration_mps2", "corner_cut_m", "start"});
  VehicleSetup v;
  v.id.value = static_cast<std::uint8_t>(n["id"].integer(1, 254));
  v.name = n["name"].text(1, kMaxName);
  v.key = readKey(n["key"]);
  v.readers = n["readers_m"].list(1, 8, readOffset);
  v.footprint = n["footprint_m"].list(3, 100, readPoint);
  const auto metres = [&n](std::string_view key, Metres& to) {
    if (n[key].present()) to = readMetres(n[key], 0.001, 10.0);
  };
  metres("reader_radius_m", v.readerRadius);
  metres("track_m", v.track);
  metres("wheel_diameter_m", v.wheelDiameter);
  if (n["max_speed_mps"].present()) v.maxSpeed = MetresPerSecond{n["max_speed_mps"].number(0.001, 20.0, "m/s")};
  if (n["max_turn_rate_radps"].present())
    v.maxTurnRate = RadiansPerSecond{n["max_turn_rate_radps"].number(0.001, 100.0, "rad/s")};
  if (n["acceleration_mps2"].present())
    v.acceleration = MetresPerSecond2{n["acceleration_mps2"].number(0.001, 100.0, "m/s^2")};
  if (n["corner_cut_m"].present()) v.cornerCut = readMetres(n["corner_cut_m"], 0.0, kMostCornerCut.value());
  if (JsonNode start = n["start"]; start.present()) {
    start.object({"x_m", "y_m", "heading_deg"});
    v.start = Pose{readXY(start), readDegrees(start["heading_deg"])};
  }
  return v;
}

RadioSetup readRadio(JsonNode n) {
  n.object({}, {"channel", "air_rate_bps", "baud"});
  RadioSetup radio;
  if (n["channel"].present()) radio.channel = n["channel"].integer(0, 31);
  const auto oneOf = [](const JsonNode& m, const auto& rates, const std::string& names) {
    const int rate = m.integer(0, 1'000'000);
    if (std::find(rates.begin(), rates.end(), rate) == rates.end()) m.fail(phrase("Core", "one of %1").with(names));
    return rate;
  };
  if (n["air_rate_bps"].present())
    radio.airRate = oneOf(n["air_rate_bps"], kAirRates, "300, 1200, 2400, 4800, 9600, 19200");
  if (n["baud"].present()) radio.baud = oneOf(n["baud"], kBauds, "1200, 2400, 4800, 9600, 19200, 38400, 57600, 115200");
  return radio;
}

std::shared_ptr<const std::string> readPicture(const JsonNode& n) {
  auto bytes = fromBase64(n.text(0, kMostJson));
  if (n.failed()) return nullptr;
  if (!bytes) {
    n.fail(phrase("Core", "a picture's bytes in base64"));
  } else if (bytes->size() > kMostPicture) {
    n.fail(phrase("Core", "a picture of at most %1 MB").with(kMostPicture / 1'000'000));
  } else if (!isPicture(*bytes)) {
    n.fail(phrase("Core", "a picture in the format PNG or JPEG"));
  } else {
    return std::make_shared<const std::string>(*std::move(bytes));
  }
  return nullptr;
}

Backdrop readBackdrop(JsonNode n) {
  n.object({"file", "origin_m", "metres_per_pixel", "picture"}, {"turn_deg", "opacity"});
  Backdrop backdrop;
  backdrop.file = n["file"].text(1, kMaxName);
  backdrop.origin = readPoint(n["origin_m"]);
  backdrop.pixel = readMetres(n["metres_per_pixel"], kLeastBackdropPixel.value(), kMostBackdropPixel.value());
  if (n["turn_deg"].present()) backdrop.turn = readDegrees(n["turn_deg"]);
  if (n["opacity"].present()) backdrop.opacity = n["opacity"].number(0.0, 1.0, phrase("Core", "opacity"));
  backdrop.picture = readPicture(n["picture"]);
  return backdrop;
}

Site readSite(JsonNode n) {
  n.object({"format", "version", "name"}, {"north_to_y_deg", "radio", "tile_types", "tiles", "placements", "loose_tags",
                                           "zones", "routes", "vehicles", "backdrop"});
  static_cast<void>(n["format"].choice({"tessera-site"}));
  static_cast<void>(n["version"].integer(kSiteFormatVersion, kSiteFormatVersion));
  Site site;
  site.name = n["name"].text(1, kMaxName);
  if (n["north_to_y_deg"].present()) site.northToY = readDegrees(n["north_to_y_deg"]);
  if (n["radio"].present()) site.radio = readRadio(n["radio"]);
  const auto lists = [&n](std::string_view key, std::size_t most, auto read, auto& to) {
    if (!n.failed() && n[key].present()) to = n[key].list(0, most, read);
  };
  lists("tile_types", kMostTileTypes, readType, site.tileTypes);
  lists("tiles", kMany, readTile, site.tiles);
  lists("placements", kMany, readPlacement, site.placements);
  lists("loose_tags", kMany, readLooseTag, site.looseTags);
  lists("zones", kSome, readZone, site.zones);
  lists("routes", kSome, readRoute, site.routes);
  lists("vehicles", kMostVehicles, readVehicle, site.vehicles);
  if (!n.failed() && n["backdrop"].present()) site.backdrop = readBackdrop(n["backdrop"]);
  return site;
}

}  // namespace

Result<Site> parseSite(std::string_view text, const std::string& name) {
  Site site;
  auto read =
      readDocument(text, name, phrase("Core", "a site"), [&site](const JsonNode& root) { site = readSite(root); });
  if (!read) return tl::unexpected{std::move(read.error())};
  return site;
}

}  // namespace tessera::floor
