#include "ui/history/comparison.h"

#include <array>
#include <map>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "floor/laid_tile.h"
#include "floor/tile_finder.h"
#include "region/region.h"

namespace tessera::ui {
namespace {

using sitediff::Change;
using sitediff::ChangeKind;
using sitediff::Subject;

ChangeLook lookOf(ChangeKind kind) {
  constexpr std::array looks{ChangeLook::Added, ChangeLook::Removed, ChangeLook::Moved, ChangeLook::Changed};
  return looks.at(static_cast<std::size_t>(kind));
}

SiteBox around(const Box& box) { return {box.low, box.high}; }

// Where things are in one state, by name.
class Finder {
public:
  explicit Finder(const floor::Site& site) {
    floor::LaidTypes types{site};
    for (std::size_t n = 0; n < site.placements.size(); ++n)
      if (const floor::TileType* type = types.find(site.placements[n], n))
        tiles_.emplace(site.placements[n].serial, boxOf(site.placements[n], *type));
    for (const floor::Zone& zone : site.zones)
      lines_.emplace(std::pair{'z', std::string_view{zone.name}}, &zone.outline);
    for (const floor::Route& route : site.routes)
      lines_.emplace(std::pair{'r', std::string_view{route.name}}, &route.vertices);
    for (const floor::LooseTag& tag : site.looseTags) tags_.emplace(tag.uid.text(), tag.place);
  }
  [[nodiscard]] std::optional<Box> tile(std::string_view serial) const {
    const auto found = tiles_.find(serial);
    return found == tiles_.end() ? std::nullopt : std::optional{found->second};
  }
  /// Nullptr: there is none of this name, or it has no point.
  [[nodiscard]] const std::vector<Point>* line(Subject subject, std::string_view name) const {
    const auto found = lines_.find({subject == Subject::Zone ? 'z' : 'r', name});
    return found == lines_.end() || found->second->empty() ? nullptr : found->second;
  }
  [[nodiscard]] std::optional<Point> tag(const std::string& uid) const {
    const auto found = tags_.find(uid);
    return found == tags_.end() ? std::nullopt : std::optional{found->second};
  }

private:
  std::unordered_map<std::string_view, Box> tiles_;
  std::map<std::pair<char, std::string_view>, const std::vector<Point>*> lines_;
  std::unordered_map<std::string, Point> tags_;
};

class Marker {
public:
  Marker(const floor::Site& before, const floor::Site& after, ChangeMarks& marks)
      : was_{before}, is_{after}, marks_{marks} {}

  void add(const Change& change) {
    ChangeMarks::Sign sign{lookOf(change.kind), {}, {}, {}};
    if (change.place) sign.place = around(*change.place);
    switch (change.subject) {
      case Subject::Tile:
        tile(change, sign);
        break;
      case Subject::Zone:
      case Subject::Route:
        line(change, sign);
        break;
      case Subject::LooseTag:
        if (const auto now = is_.tag(change.name); change.kind == ChangeKind::Moved && now) {
          sign.place = {*now, *now};
          sign.from = was_.tag(change.name);
        }
        break;
      default:
        break;
    }
    marks_.signs.push_back(std::move(sign));
  }

  // Tiles that lie side by side become one area.
  void finish() {
    for (std::size_t look = 0; look < boxes_.size(); ++look) outline(static_cast<ChangeLook>(look), boxes_.at(look));
    outline(ChangeLook::Moved, left_);
  }

private:
  void tile(const Change& change, ChangeMarks::Sign& sign) {
    const auto now = is_.tile(change.name);
    const auto then = was_.tile(change.name);
    if (change.kind == ChangeKind::Moved && now && then) {
      sign.place = around(*now);
      sign.from = middleOf(*then);
      left_.push_back(*then);
    }
    const auto& box = change.kind == ChangeKind::Removed ? then : now;
    if (box) boxes_.at(static_cast<std::size_t>(sign.look)).push_back(*box);
  }

  void line(const Change& change, ChangeMarks::Sign& sign) {
    const auto* now = is_.line(change.subject, change.name);
    const auto* then = was_.line(change.subject, change.name);
    const bool closed = change.subject == Subject::Zone;
    if (then != nullptr && (now == nullptr || *now != *then)) marks_.shapes.push_back({sign.look, {*then}, closed});
    if (now != nullptr) marks_.shapes.push_back({sign.look, {*now}, closed});
    if (change.kind == ChangeKind::Moved && now != nullptr && then != nullptr) {
      sign.place = around(boxAround(*now));
      sign.from = middleOf(boxAround(*then));
    }
  }

  void outline(ChangeLook look, const std::vector<Box>& boxes) {
    if (boxes.empty()) return;
    ChangeMarks::Shape shape{look, {}, true};
    const region::Region area = region::Region::unionOf(boxes);
    for (const region::Ring& ring : area.rings()) {
      std::vector<Point> line;
      for (const region::Node& node : ring) line.push_back(region::pointOf(node));
      shape.lines.push_back(std::move(line));
    }
    marks_.shapes.push_back(std::move(shape));
  }

  Finder was_;
  Finder is_;
  ChangeMarks& marks_;
  std::array<std::vector<Box>, 4> boxes_;  // of tiles, by look
  std::vector<Box> left_;                  // where moved tiles lay
};

}  // namespace

Comparison compare(std::shared_ptr<const floor::SiteMap> before, std::shared_ptr<const floor::SiteMap> after) {
  Comparison comparison{std::move(before), std::move(after), {}, {}};
  const floor::Site& was = comparison.before->site();
  const floor::Site& is = comparison.after->site();
  if (comparison.before == comparison.after) return comparison;
  comparison.changes = sitediff::difference(was, is);
  Marker marker{was, is, comparison.marks};
  for (const Change& change : comparison.changes) marker.add(change);
  marker.finish();
  return comparison;
}

}  // namespace tessera::ui
