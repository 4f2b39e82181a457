#include "ui/find/place_search.h"

#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <cctype>
#include <unordered_map>

#include "floor/laid_tile.h"

namespace tessera::ui {
namespace {

struct Candidate {
  int rank = 0;  ///< the smaller the better
  FoundPlace place;
};

// 0 the same, 1 begins so, 2 has it within; nullopt: nothing of it.
std::optional<int> rankOf(const QString& name, const QString& wanted) {
  const auto at = name.indexOf(wanted, 0, Qt::CaseInsensitive);
  if (at < 0) return std::nullopt;
  return at > 0 ? 2 : name.size() > wanted.size() ? 1 : 0;
}

std::optional<FoundPlace> coordinates(const QString& text) {
  static const QRegularExpression parts{QStringLiteral("[;\\s]+")};
  const QStringList words = text.split(parts, Qt::SkipEmptyParts);
  if (words.size() != 2) return std::nullopt;
  const auto number = [](const QString& word, bool& good) {
    const double here = QLocale().toDouble(word, &good);
    return good ? here : QLocale::c().toDouble(word, &good);
  };
  bool x = false;
  bool y = false;
  const Point at{Metres{number(words[0], x)}, Metres{number(words[1], y)}};
  // Not a number fails both comparisons.
  if (!x || !y || !(abs(at.x) <= Metres{1e6}) || !(abs(at.y) <= Metres{1e6})) return std::nullopt;
  SiteBox box;
  box.add(at);
  return FoundPlace{FoundPlace::Kind::Coordinates, text.simplified(), box.grown(kAroundFound)};
}

class Search {
public:
  Search(const floor::SiteMap& map, QString wanted) : map_{map}, site_{map.site()}, wanted_{std::move(wanted)} {}

  std::vector<Candidate> run() {
    tags();
    tiles();
    for (const floor::Zone& zone : site_.zones) named(FoundPlace::Kind::Zone, zone.name, zone.outline);
    for (const floor::Route& route : site_.routes) named(FoundPlace::Kind::Route, route.name, route.vertices);
    for (const floor::VehicleSetup& vehicle : site_.vehicles) {
      if (vehicle.start) named(FoundPlace::Kind::Vehicle, vehicle.name, std::vector{vehicle.start->position});
    }
    return std::move(found_);
  }

private:
  void named(FoundPlace::Kind kind, const std::string& name, const std::vector<Point>& points) {
    const QString shown = QString::fromStdString(name);
    const auto rank = rankOf(shown, wanted_);
    SiteBox box;
    for (const Point& p : points) box.add(p);
    if (rank && !box.empty()) found_.push_back({*rank, {kind, shown, box.grown(kAroundFound)}});
  }

  void tags() {
    std::string digits;
    for (const QChar c : wanted_) {
      if (c == QLatin1Char(':') || c == QLatin1Char('-') || c.isSpace()) continue;
      if (c.unicode() > 127 || std::isxdigit(c.toLatin1()) == 0) return;
      digits += static_cast<char>(std::toupper(c.toLatin1()));
    }
    if (digits.size() < 4) return;
    for (const floor::PlacedTag& tag : map_.tags()) {
      if (!begins(tag.uid.bytes(), digits)) continue;
      SiteBox box;
      box.add(tag.place);
      const std::string text = tag.uid.text();
      found_.push_back({text.size() == digits.size() ? 0 : 1,
                        {FoundPlace::Kind::Tag, QString::fromStdString(text), box.grown(kAroundFound)}});
      if (found_.size() > 200) return;
    }
  }

  // Without making a text of each of a million UIDs.
  static bool begins(std::span<const std::uint8_t> bytes, const std::string& digits) {
    constexpr std::string_view kHex = "0123456789ABCDEF";
    if (digits.size() > 2 * bytes.size()) return false;
    for (std::size_t n = 0; n < digits.size(); ++n) {
      const unsigned nibble = n % 2 == 0 ? bytes[n / 2] >> 4U : bytes[n / 2] & 15U;
      if (kHex[nibble] != digits[n]) return false;
    }
    return true;
  }

  void tiles() {
    std::unordered_map<std::string_view, const floor::TileType*> types;
    for (const floor::TileType& type : site_.tileTypes) types.emplace(type.name, &type);
    std::unordered_map<std::string_view, const floor::Placement*> wanted;
    for (const floor::Placement& placement : site_.placements) {
      if (rankOf(QString::fromStdString(placement.serial), wanted_)) wanted.emplace(placement.serial, &placement);
    }
    for (const floor::Tile& tile : site_.tiles) {
      const auto placement = wanted.find(tile.serial);
      const auto type = types.find(tile.type);
      if (placement == wanted.end() || type == types.end()) continue;
      const Box area = floor::boxOf(*placement->second, *type->second);
      SiteBox box;
      box.add(area.low);
      box.add(area.high);
      const QString shown = QString::fromStdString(tile.serial);
      found_.push_back({rankOf(shown, wanted_).value_or(2), {FoundPlace::Kind::Tile, shown, box.grown(kAroundFound)}});
    }
  }

  const floor::SiteMap& map_;
  const floor::Site& site_;
  QString wanted_;
  std::vector<Candidate> found_;
};

}  // namespace

std::vector<FoundPlace> findPlaces(const floor::SiteMap& map, const QString& text, std::size_t most) {
  const QString wanted = text.trimmed();
  std::vector<FoundPlace> places;
  if (wanted.isEmpty()) return places;
  if (auto at = coordinates(wanted)) places.push_back(*std::move(at));
  std::vector<Candidate> found = Search{map, wanted}.run();
  std::stable_sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
    return a.rank != b.rank ? a.rank < b.rank : a.place.name.size() < b.place.name.size();
  });
  for (Candidate& one : found) {
    if (places.size() >= most) break;
    places.push_back(std::move(one.place));
  }
  return places;
}

}  // namespace tessera::ui
