#include "floor/site_map.h"

#include <algorithm>
#include <iterator>

#include "floor/tag_change.h"

namespace tessera::floor {
namespace {

void append(Contradictions& all, Contradictions more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

tl::unexpected<Error> refusal(const Contradiction& contradiction) { return failure(contradiction.sentence); }

}  // namespace

Result<std::shared_ptr<const SiteMap>> SiteMap::build(Site site, Ambiguity ambiguity) {
  const bool carried = ambiguity == Ambiguity::Carried;
  Contradictions told = doubledTiles(site);
  if (!told.empty() && !carried) return refusal(told.front());
  auto laid = layTags(site, told);
  if (!laid) return tl::unexpected{std::move(laid.error())};
  append(told, std::move(laid->contradictions));
  if (!told.empty() && !carried) return refusal(told.front());
  // The table finds a UID at two places by itself, and refuses.
  auto table = carried ? TagTable::build(laid->tags) : TagTable::build(std::move(laid->tags));
  if (carried && (!told.empty() || !table)) {
    append(told, takeOutDoubled(site, laid->tags));
    table = TagTable::build(std::move(laid->tags));
  }
  if (!table) return tl::unexpected{std::move(table.error())};
  append(told, doubledNames(site));
  if (!told.empty() && !carried) return refusal(told.front());
  return with(std::move(site), *std::move(table), std::move(told));
}

Result<std::shared_ptr<const SiteMap>> SiteMap::rebuild(Site site, const SiteMap& before, const SitePatch& change,
                                                        Ambiguity ambiguity) {
  if (!before.contradictions_.empty()) {
    auto map = build(std::move(site), Ambiguity::Carried);
    if (!map || ambiguity == Ambiguity::Carried) return map;
    if (const auto* added = newAmong((*map)->contradictions_, before.contradictions_)) return refusal(*added);
    return map;
  }
  auto table = before.table_;
  if (change.movesTags()) {
    const auto tags = tagChange(before.site_, site, change);
    table = tags ? table->changed(tags->removed, tags->added) : nullptr;
    if (!table) return build(std::move(site), ambiguity);
  }
  Contradictions told = doubledNames(site);
  if (!told.empty() && ambiguity == Ambiguity::Refused) return refusal(told.front());
  return with(std::move(site), std::move(table), std::move(told));
}

std::shared_ptr<const SiteMap> SiteMap::with(Site site, std::shared_ptr<const TagTable> table, Contradictions told) {
  std::shared_ptr<SiteMap> map{new SiteMap};
  map->site_ = std::move(site);
  map->table_ = std::move(table);
  map->contradictions_ = std::move(told);
  return map;
}

const Route* SiteMap::route(const std::string& name) const {
  const auto found =
      std::find_if(site_.routes.begin(), site_.routes.end(), [&](const Route& r) { return r.name == name; });
  return found == site_.routes.end() ? nullptr : &*found;
}

const VehicleSetup* SiteMap::vehicle(VehicleId id) const {
  const auto found =
      std::find_if(site_.vehicles.begin(), site_.vehicles.end(), [&](const VehicleSetup& v) { return v.id == id; });
  return found == site_.vehicles.end() ? nullptr : &*found;
}

}  // namespace tessera::floor
