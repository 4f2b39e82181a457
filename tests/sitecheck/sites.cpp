#include "sitecheck/sites.h"

#include "floor/new_floor.h"
#include "floor/route_legs.h"

namespace tessera::sitecheck {

using floor::Site;
using floor::ZoneKind;

std::vector<Point> rectangle(double x0, double y0, double x1, double y1) {
  return {at(x0, y0), at(x1, y0), at(x1, y1), at(x0, y1)};
}

floor::Zone zone(const std::string& name, ZoneKind kind, std::vector<Point> outline) {
  return {name, kind, std::move(outline), {}, {}};
}

Site goodFloor() {
  Site site = floor::layNewFloor({"Hall", floor::usualTileTypes().front(), 5, 4, true}).value();
  site.routes = {{"round", {at(0.4, 0.4), at(2.6, 0.4), at(2.6, 2.0), at(0.4, 2.0)}, Metres{0.2}}};
  return site;
}

Faults faultsOf(const Site& site, FaultKind kind) {
  Faults found;
  checkSite(site).forEach([&](const Fault& fault) {
    if (fault.kind == kind) found.push_back(fault);
  });
  return found;
}

std::string listOf(const Faults& faults) {
  std::string s;
  for (const Fault& fault : faults) s += std::string{codeOf(fault.kind)} + ": " + fault.sentence.english() + "\n";
  return s;
}

namespace {

class Editor {
public:
  Editor(Site& site, std::mt19937_64& random) : site_{site}, random_{random} {}

  void tiles() {
    switch (below(7)) {
      case 0:
        if (auto* p = any(site_.placements)) p->origin = p->origin + Offset{Metres{step()}, Metres{step()}};
        return;
      case 1:
        if (auto* p = any(site_.placements)) p->quarterTurns = static_cast<int>(below(4));
        return;
      case 2:
        if (auto* p = any(site_.placements)) site_.placements.push_back(*p);
        return;
      case 3:
        if (auto* t = any(site_.tiles)) site_.tiles.push_back(*t);
        return;
      case 4:
        erase(site_.placements);
        return;
      case 5:
        erase(site_.tiles);
        return;
      default:
        if (auto* t = any(site_.tiles))
          t->type = below(2) == 0 || site_.tileTypes.empty() ? "unknown" : site_.tileTypes.front().name;
    }
  }
  void tags() {
    auto* t = any(site_.tiles);
    auto* other = any(site_.tiles);
    if (t == nullptr) return;
    switch (below(4)) {
      case 0:
        if (auto* uid = any(t->uids)) *uid = {};
        return;
      case 1:
        if (auto* uid = any(t->uids))
          if (auto* from = any(other->uids)) *uid = *from;
        return;
      case 2:
        t->uids.clear();
        return;
      default:
        if (auto* from = any(other->uids); from != nullptr && below(2) == 0)
          site_.looseTags.push_back({*from, somewhere()});
        else
          erase(site_.looseTags);
    }
  }
  void zones() {
    switch (below(6)) {
      case 0:
        site_.zones.push_back(zone("Z" + std::to_string(below(4)), static_cast<ZoneKind>(below(8)),
                                   {somewhere(), somewhere(), somewhere(), somewhere()}));
        return;
      case 1:
        erase(site_.zones);
        return;
      case 2:
        if (auto* z = any(site_.zones)) z->kind = static_cast<ZoneKind>(below(8));
        return;
      case 3:
        if (auto* z = any(site_.zones))
          if (auto* p = any(z->outline)) *p = somewhere();
        return;
      case 4:
        if (auto* z = any(site_.zones)) z->direction = Radians{step()};
        return;
      default:
        if (auto* z = any(site_.zones); z != nullptr && !z->outline.empty()) z->outline.push_back(z->outline.front());
    }
  }
  void routes() {
    switch (below(6)) {
      case 0:
        site_.routes.push_back({"R" + std::to_string(below(4)), {somewhere(), somewhere(), somewhere()}, Metres{0.2}});
        return;
      case 1:
        erase(site_.routes);
        return;
      case 2:
        if (auto* r = any(site_.routes); r != nullptr && !r->vertices.empty())
          insertVertex(*r, r->vertices.size(), Point{r->vertices.back()});
        return;
      case 3:
        if (auto* r = any(site_.routes)) eraseVertex(*r, below(6));
        return;
      case 4:
        if (auto* r = any(site_.routes)) setLegSpeed(*r, below(4), speed());
        return;
      default:
        if (auto* r = any(site_.routes))
          if (auto* p = any(r->vertices)) *p = somewhere();
    }
  }
  void vehicles() {
    switch (below(5)) {
      case 0:
        if (auto* v = any(site_.vehicles)) site_.vehicles.push_back(*v);
        return;
      case 1:
        erase(site_.vehicles);
        return;
      case 2:
        if (auto* v = any(site_.vehicles)) v->start = Pose{somewhere(), {}};
        return;
      case 3:
        if (auto* v = any(site_.vehicles)) v->key = {};
        return;
      default:
        site_.radio.channel = static_cast<int>(below(40));
    }
  }
  void backdrop() {
    if (!site_.backdrop || below(5) == 0) {
      const std::string bytes = "\xFF\xD8\xFF" + std::to_string(below(2));
      site_.backdrop = floor::Backdrop{"hall.jpg", std::make_shared<const std::string>(bytes), {}, {}, {}, 0.5};
      return;
    }
    switch (below(5)) {
      case 0:
        site_.backdrop.reset();
        return;
      case 1:
        site_.backdrop->origin = somewhere();
        return;
      case 2:
        site_.backdrop->turn = Radians{step()};
        return;
      case 3:
        site_.backdrop->pixel = Metres{0.02 + step() / 10.0};
        return;
      default:
        site_.backdrop->opacity = 0.5 + step();
    }
  }
  std::size_t below(std::size_t n) { return random_() % n; }

private:
  double step() { return std::uniform_real_distribution<double>{-0.1, 0.1}(random_); }
  std::optional<MetresPerSecond> speed() {
    if (below(4) == 0) return std::nullopt;
    return MetresPerSecond{0.05 * static_cast<double>(1 + below(16))};
  }
  Point somewhere() {
    std::uniform_real_distribution<double> on{-0.5, 3.5};
    return at(on(random_), on(random_));
  }
  template <class Items>
  auto any(Items& items) -> decltype(&items[0]) {
    return items.empty() ? nullptr : &items[below(items.size())];
  }
  template <class Items>
  void erase(Items& items) {
    if (!items.empty()) items.erase(items.begin() + static_cast<std::ptrdiff_t>(below(items.size())));
  }

  Site& site_;
  std::mt19937_64& random_;
};

}  // namespace

void editAtRandom(Site& site, std::mt19937_64& random) {
  Editor editor{site, random};
  switch (editor.below(6)) {
    case 0:
      return editor.tiles();
    case 1:
      return editor.tags();
    case 2:
      return editor.zones();
    case 3:
      return editor.routes();
    case 4:
      return editor.backdrop();
    default:
      return editor.vehicles();
  }
}

}  // namespace tessera::sitecheck
