// Site to *.tessera.json: one item a line, keys in a fixed order, numbers as short as they read back exactly.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "floor/picture.h"
#include "floor/site_json.h"
#include "floor/site_names.h"

namespace tessera::floor {
namespace {

// The shortest decimal that reads back as the same double; no exponent at usual sizes, no minus zero.
std::string decimal(double v) {
  if (v == 0.0) return "0";
  std::array<char, 64> text{};
  const double size = std::abs(v);
  const auto end = size >= 1e-6 && size < 1e15
                       ? std::to_chars(text.data(), text.data() + text.size(), v, std::chars_format::fixed)
                       : std::to_chars(text.data(), text.data() + text.size(), v);
  return {text.data(), end.ptr};
}

// v rounded to so many significant digits.
double rounded(double v, int digits) {
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), v, std::chars_format::scientific, digits - 1);
  double back = 0.0;
  std::from_chars(text.data(), end.ptr, back);
  return back;
}

// Degrees that read back as the same radians, with the fewest digits.
std::optional<std::string> exactDegrees(Radians angle) {
  const double middle = degrees(angle);
  const double down = std::nextafter(middle, -1e9);
  const double up = std::nextafter(middle, 1e9);
  for (int digits = 1; digits <= 17; ++digits) {
    for (double d : {middle, down, up, std::nextafter(down, -1e9), std::nextafter(up, 1e9)}) {
      if (const double r = rounded(d, digits); fromDegrees(r) == angle) return decimal(r);
    }
  }
  return std::nullopt;
}

// A few radians lie between the images of two neighbouring doubles of degrees: those become the nearest image (2e-16
// off).
std::string inDegrees(Radians angle) {
  if (auto text = exactDegrees(angle)) return *text;
  const Radians image = fromDegrees(degrees(angle));
  return exactDegrees(image).value_or(decimal(degrees(angle)));
}

std::string jsonText(const std::string& text) {
  using nlohmann::json;
  return json(text).dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string jsonText(std::string_view text) { return jsonText(std::string{text}); }

template <class Items, class Write>
std::string inBrackets(const Items& items, Write write) {
  std::string s = "[";
  for (const auto& item : items) s += (s.size() > 1 ? ", " : "") + write(item);
  return s + "]";
}

template <class P>  // Point or Offset
std::string pair(P p) {
  return "[" + decimal(p.x.value()) + ", " + decimal(p.y.value()) + "]";
}

std::string xy(Point p) { return "\"x_m\": " + decimal(p.x.value()) + ", \"y_m\": " + decimal(p.y.value()); }

std::string line(const TileType& t) {
  std::ostringstream s;
  s << "{\"name\": " << jsonText(t.name) << ", \"width_m\": " << decimal(t.width.value())
    << ", \"height_m\": " << decimal(t.height.value()) << ", \"pitch_m\": " << decimal(t.pitch.value())
    << ", \"margin_m\": " << pair(t.margin) << ", \"columns\": " << t.columns << ", \"rows\": " << t.rows
    << ", \"pattern\": " << jsonText(kPatternNames.at(static_cast<std::size_t>(t.pattern)));
  if (t.pattern == Pattern::OneInTwo) s << ", \"starts_with_gap\": " << (t.startsWithGap ? "true" : "false");
  if (t.pattern == Pattern::Custom) {
    std::vector<std::string> rows(static_cast<std::size_t>(t.rows));
    const auto columns = static_cast<std::size_t>(t.columns);
    for (std::size_t i = 0; i < rows.size() * columns; ++i)
      rows[i / columns] += i < t.custom.size() && t.custom[i] ? '#' : '.';
    s << ", \"custom\": " << inBrackets(rows, [](const std::string& row) { return jsonText(row); });
  }
  s << "}";
  return s.str();
}

std::string line(const Tile& t) {
  const auto uid = [](const TagUid& u) { return u.empty() ? std::string{"null"} : jsonText(u.text()); };
  return "{\"serial\": " + jsonText(t.serial) + ", \"type\": " + jsonText(t.type) +
         ", \"uids\": " + inBrackets(t.uids, uid) + "}";
}

std::string line(const Placement& p) {
  return "{\"serial\": " + jsonText(p.serial) + ", " + xy(p.origin) +
         ", \"quarter_turns\": " + std::to_string(p.quarterTurns) + "}";
}

std::string line(const LooseTag& t) { return "{\"uid\": " + jsonText(t.uid.text()) + ", " + xy(t.place) + "}"; }

std::string line(const Zone& z) {
  std::string s = "{\"name\": " + jsonText(z.name) +
                  ", \"kind\": " + jsonText(kZoneKindNames.at(static_cast<std::size_t>(z.kind))) +
                  ", \"outline_m\": " + inBrackets(z.outline, pair<Point>);
  if (z.speed) s += ", \"speed_mps\": " + decimal(z.speed->value());
  if (z.direction) s += ", \"direction_deg\": " + inDegrees(*z.direction);
  return s + "}";
}

std::string line(const Route& r) {
  const auto isSet = [](const std::optional<MetresPerSecond>& speed) { return speed.has_value(); };
  const auto speed = [](const std::optional<MetresPerSecond>& v) { return v ? decimal(v->value()) : "null"; };
  std::string s = "{\"name\": " + jsonText(r.name) + ", \"control_spacing_m\": " + decimal(r.controlSpacing.value()) +
                  ", \"vertices_m\": " + inBrackets(r.vertices, pair<Point>);
  // Only where there is one: sites without keep their files to the byte, and older programs read them.
  if (std::any_of(r.legSpeeds.begin(), r.legSpeeds.end(), isSet))
    s += ", \"leg_speeds_mps\": " + inBrackets(r.legSpeeds, speed);
  return s + "}";
}

std::string keyText(const wire::Key& key) {
  std::string s;
  for (std::uint8_t byte : key) {
    s += "0123456789ABCDEF"[byte >> 4];
    s += "0123456789ABCDEF"[byte & 0x0F];
  }
  return s;
}

std::string line(const VehicleSetup& v) {
  std::ostringstream s;
  s << "{\"id\": " << int{v.id.value} << ", \"name\": " << jsonText(v.name) << ", \"key\": " << jsonText(keyText(v.key))
    << ",\n     \"readers_m\": " << inBrackets(v.readers, pair<Offset>)
    << ", \"reader_radius_m\": " << decimal(v.readerRadius.value())
    << ",\n     \"footprint_m\": " << inBrackets(v.footprint, pair<Point>)
    << ",\n     \"track_m\": " << decimal(v.track.value())
    << ", \"wheel_diameter_m\": " << decimal(v.wheelDiameter.value())
    << ", \"max_speed_mps\": " << decimal(v.maxSpeed.value())
    << ", \"max_turn_rate_radps\": " << decimal(v.maxTurnRate.value())
    << ", \"acceleration_mps2\": " << decimal(v.acceleration.value());
  // Only where it rounds them: sites without keep their files to the byte, and older programs read them.
  if (v.cornerCut > Metres{}) s << ", \"corner_cut_m\": " << decimal(v.cornerCut.value());
  if (v.start)
    s << ",\n     \"start\": {" << xy(v.start->position) << ", \"heading_deg\": " << inDegrees(v.start->heading) << "}";
  s << "}";
  return s.str();
}

std::string line(const Backdrop& b) {
  return "{\"file\": " + jsonText(b.file) + ", \"origin_m\": " + pair(b.origin) +
         ", \"metres_per_pixel\": " + decimal(b.pixel.value()) + ", \"turn_deg\": " + inDegrees(b.turn) +
         ", \"opacity\": " + decimal(b.opacity) + ",\n    \"picture\": \"" + toBase64(*b.picture) + "\"}";
}

template <class Items>
std::string section(const std::string& key, const Items& items) {
  std::string s = ",\n  \"" + key + "\": [";
  for (std::size_t i = 0; i < items.size(); ++i) s += (i == 0 ? "\n    " : ",\n    ") + line(items[i]);
  return s + (items.empty() ? "]" : "\n  ]");
}

}  // namespace

std::string writeSite(const Site& site) {
  std::string s = "{\n  \"format\": \"tessera-site\",\n  \"version\": " + std::to_string(kSiteFormatVersion);
  s += ",\n  \"name\": " + jsonText(site.name);
  s += ",\n  \"north_to_y_deg\": " + inDegrees(site.northToY);
  s += ",\n  \"radio\": {\"channel\": " + std::to_string(site.radio.channel) +
       ", \"air_rate_bps\": " + decimal(site.radio.airRate) + ", \"baud\": " + std::to_string(site.radio.baud) + "}";
  s += section("tile_types", site.tileTypes);
  s += section("tiles", site.tiles);
  s += section("placements", site.placements);
  s += section("loose_tags", site.looseTags);
  s += section("zones", site.zones);
  s += section("routes", site.routes);
  s += section("vehicles", site.vehicles);
  // Files without a picture are as they were before there were any.
  if (site.backdrop && site.backdrop->picture) s += ",\n  \"backdrop\": " + line(*site.backdrop);
  return s + "\n}\n";
}

}  // namespace tessera::floor
