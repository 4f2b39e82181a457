// UIDs that stand at two places, and tiles whose tags are not all registered.
#include <algorithm>
#include <bit>

#include "floor/laid_tile.h"
#include "sitecheck/checks.h"
#include "sitecheck/wording.h"

namespace tessera::sitecheck {
namespace {

constexpr std::uint32_t kLoose = kGone;
using Entry = RepeatedUid::End;

std::vector<Entry> allUids(const floor::Site& site) {
  std::vector<Entry> entries;
  std::size_t count = site.looseTags.size();
  for (const floor::Tile& tile : site.tiles) count += tile.uids.size();
  entries.reserve(count);
  for (std::uint32_t t = 0; t < site.tiles.size(); ++t) {
    const auto& uids = site.tiles[t].uids;
    for (std::uint32_t n = 0; n < uids.size(); ++n)
      if (!uids[n].empty()) entries.push_back({uids[n], t, n});
  }
  for (std::uint32_t n = 0; n < site.looseTags.size(); ++n)
    if (!site.looseTags[n].uid.empty()) entries.push_back({site.looseTags[n].uid, kLoose, n});
  return entries;
}

// Calls twice(first, later) for each entry whose UID has stood before.
template <class Twice>
void forEachRepeated(const std::vector<Entry>& entries, Twice twice) {
  const std::size_t mask = std::bit_ceil(2 * entries.size() + 2) - 1;
  std::vector<std::uint32_t> table(mask + 1, 0);
  for (std::uint32_t i = 0; i < entries.size(); ++i) {
    std::size_t at = entries[i].uid.hash(0) & mask;
    while (table[at] != 0 && entries[table[at] - 1].uid != entries[i].uid) at = (at + 1) & mask;
    if (table[at] == 0)
      table[at] = i + 1;
    else
      twice(entries[table[at] - 1], entries[i]);
  }
}

class Describer {
public:
  explicit Describer(const Context& context) : context_{context} {}
  [[nodiscard]] std::optional<Point> placeOf(const Entry& e) const {
    if (e.tile == kLoose) return context_.site.looseTags[e.position].place;
    const std::uint32_t laid = context_.plan.laidOf(e.tile);
    if (laid == FloorPlan::kNone || e.position >= context_.plan.offsetsOf(context_.plan.laid()[laid].type).size())
      return std::nullopt;
    return context_.plan.placeOf(context_.site, context_.plan.laid()[laid], e.position);
  }
  [[nodiscard]] Sentence textOf(const Entry& e) const {
    if (e.tile == kLoose)
      return phrase("Core", "a loose tag at %1 m").with(placeText(context_.site.looseTags[e.position].place));
    return phrase("Core", "tag %1 of tile \"%2\"").with(e.position + 1, context_.site.tiles[e.tile].serial);
  }
  [[nodiscard]] Fix fixOf(const Entry& e) const {
    if (e.tile == kLoose)
      return {phrase("Core", "Forget the loose tag %1").with(e.uid.text()),
              ForgetLooseTag{context_.site.looseTags[e.position]}};
    const std::string& serial = context_.site.tiles[e.tile].serial;
    return {phrase("Core", "Clear tag %1 of tile \"%2\"").with(e.position + 1, serial),
            ClearUid{serial, e.position, e.uid}};
  }
  void name(const Entry& e, std::vector<Object>& objects) const {
    if (e.tile != kLoose) objects.push_back({ObjectKind::Tile, context_.site.tiles[e.tile].serial});
  }

private:
  const Context& context_;
};

}  // namespace

std::vector<RepeatedUid> repeatedUids(const floor::Site& site) {
  std::vector<RepeatedUid> repeated;
  forEachRepeated(allUids(site), [&](const Entry& first, const Entry& later) { repeated.push_back({first, later}); });
  return repeated;
}

std::vector<std::uint32_t> registeredTags(const floor::Site& site) {
  std::vector<std::uint32_t> counts;
  counts.reserve(site.tiles.size());
  for (const floor::Tile& tile : site.tiles)
    counts.push_back(static_cast<std::uint32_t>(
        std::count_if(tile.uids.begin(), tile.uids.end(), [](const floor::TagUid& uid) { return !uid.empty(); })));
  return counts;
}

Faults checkUids(const Context& context) {
  Faults faults;
  FaultList errors{faults, FaultKind::UidTwice, Severity::Error, context.options.mostOfAKind};
  FaultList warnings{faults, FaultKind::UidTwice, Severity::Warning, context.options.mostOfAKind};
  const Describer describe{context};
  for (const auto& [first, later] : context.repeated) {
    const auto a = describe.placeOf(first);
    const auto b = describe.placeOf(later);
    std::optional<Box> place;
    if (a && b && isPlace(boxAround({*a, *a}, {*b, *b}))) place = boxAround({*a, *a}, {*b, *b});
    // While one of the two tiles is not laid, vehicles are not misled.
    (a && b ? errors : warnings).add(place, [&, &first = first, &later = later] {
      Fault fault{.sentence = phrase("Core", "Tag %1 is registered twice: as %2 and as %3.")
                                  .with(first.uid.text(), describe.textOf(first), describe.textOf(later)),
                  .objects = {{ObjectKind::Tag, first.uid.text()}},
                  .fix = describe.fixOf(later)};
      describe.name(first, fault.objects);
      describe.name(later, fault.objects);
      return fault;
    });
  }
  errors.close();
  warnings.close();
  return faults;
}

Faults checkRegistration(const Context& context) {
  Faults faults;
  const std::size_t most = context.options.mostOfAKind;
  FaultList none{faults, FaultKind::TileUnregistered, Severity::Warning, most};
  FaultList some{faults, FaultKind::TilePartlyRegistered, Severity::Warning, most};
  FaultList many{faults, FaultKind::TooManyUids, Severity::Error, most};
  for (const LaidTile& laid : context.plan.laid()) {
    const floor::Tile& tile = context.site.tiles[laid.tile];
    const std::size_t tags = context.plan.offsetsOf(laid.type).size();
    const std::size_t registered = context.registered[laid.tile];
    const auto fault = [&](const Sentence& sentence) {
      return Fault{.sentence = sentence, .objects = {{ObjectKind::Tile, tile.serial}}};
    };
    if (tile.uids.size() > tags)
      many.add(laid.box, [&] {
        Fault told = fault(phrase("Core", "Tile \"%1\" has %2 UIDs, but its type \"%3\" has only %4 tags.")
                               .with(tile.serial, tile.uids.size(), tile.type, tags));
        told.fix = Fix{phrase("Core", "Drop the UIDs of tile \"%1\" beyond its %2 tags").with(tile.serial, tags),
                       DropUids{tile, tags}};
        return told;
      });
    else if (registered == 0 && tags > 0)
      none.add(laid.box,
               [&] { return fault(phrase("Core", "No tag of tile \"%1\" is registered.").with(tile.serial)); });
    else if (registered < tags)
      some.add(laid.box, [&] {
        return fault(
            phrase("Core", "Tile \"%1\" has %2 of its %3 tags registered.").with(tile.serial, registered, tags));
      });
  }
  none.close();
  some.close();
  many.close();
  return faults;
}

}  // namespace tessera::sitecheck
