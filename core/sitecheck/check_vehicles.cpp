// Vehicles that nobody could command, and the radio that they share.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "floor/site_names.h"
#include "sitecheck/checks.h"
#include "sitecheck/wording.h"
#include "wire/airtime.h"
#include "wire/frame.h"
#include "wire/messages.h"

namespace tessera::sitecheck {
namespace {

using floor::VehicleSetup;

Fault vehicleFault(FaultKind kind, Severity severity, const VehicleSetup& v, const Sentence& sentence) {
  return {kind, severity, sentence, {}, {{ObjectKind::Vehicle, v.name}}, {}};
}

std::optional<VehicleId> freeAddress(const std::vector<VehicleSetup>& vehicles) {
  std::set<int> taken;
  for (const VehicleSetup& v : vehicles) taken.insert(v.id.value);
  for (int id = 1; id <= 254; ++id)
    if (!taken.contains(id)) return VehicleId{static_cast<std::uint8_t>(id)};
  return std::nullopt;
}

void giveAddress(const Context& context, const VehicleSetup& v, Fault& fault) {
  if (const auto id = freeAddress(context.site.vehicles))
    fault.fix = Fix{phrase("Core", "Give vehicle \"%1\" the address %2").with(v.name, id->value), GiveAddress{v, *id}};
}

void names(const Context& context, Faults& faults) {
  std::map<VehicleId, const VehicleSetup*> addresses;
  std::map<std::string_view, const VehicleSetup*> called;
  std::map<wire::Key, const VehicleSetup*> keys;
  for (const VehicleSetup& v : context.site.vehicles) {
    if (v.id.value == 0 || v.id.value == 255) {
      faults.push_back(vehicleFault(
          FaultKind::VehicleAddressInvalid, Severity::Error, v,
          phrase("Core", "Vehicle \"%1\" has the address %2; addresses run from 1 to 254.").with(v.name, v.id.value)));
      giveAddress(context, v, faults.back());
    }
    if (const auto [first, isNew] = addresses.try_emplace(v.id, &v); !isNew) {
      faults.push_back(vehicleFault(FaultKind::VehicleAddressTwice, Severity::Error, v,
                                    phrase("Core", "Vehicles \"%1\" and \"%2\" have the same address %3.")
                                        .with(first->second->name, v.name, v.id.value)));
      faults.back().objects.push_back({ObjectKind::Vehicle, first->second->name});
      giveAddress(context, v, faults.back());
    }
    if (!called.try_emplace(v.name, &v).second)
      faults.push_back(vehicleFault(FaultKind::VehicleTwice, Severity::Warning, v,
                                    phrase("Core", "Two vehicles are called \"%1\".").with(v.name)));
    if (v.key == wire::Key{}) {
      faults.push_back(vehicleFault(FaultKind::VehicleWithoutKey, Severity::Error, v,
                                    phrase("Core", "Vehicle \"%1\" has no key: it has not been paired.").with(v.name)));
    } else if (const auto [first, isNew] = keys.try_emplace(v.key, &v); !isNew) {
      faults.push_back(
          vehicleFault(FaultKind::VehicleKeyShared, Severity::Warning, v,
                       phrase("Core", "Vehicles \"%1\" and \"%2\" have the same key: each could speak for the other.")
                           .with(first->second->name, v.name)));
      faults.back().objects.push_back({ObjectKind::Vehicle, first->second->name});
    }
  }
}

void bodies(const Context& context, Faults& faults) {
  for (const VehicleSetup& v : context.site.vehicles) {
    if (v.readers.empty())
      faults.push_back(vehicleFault(FaultKind::VehicleWithoutReaders, Severity::Error, v,
                                    phrase("Core", "Vehicle \"%1\" has no readers: it cannot see tags.").with(v.name)));
    if (region::Region::of(v.footprint).empty())
      faults.push_back(vehicleFault(FaultKind::VehicleWithoutFootprint, Severity::Error, v,
                                    phrase("Core", "The outline of vehicle \"%1\" has no area.").with(v.name)));
  }
}

bool isOneOf(std::span<const int> allowed, double value) {
  return std::any_of(allowed.begin(), allowed.end(), [value](int a) { return static_cast<double>(a) == value; });
}

// Seconds from a vehicle's command to its next: the packets of all vehicles once around.
Seconds roundOf(const floor::RadioSetup& radio, std::size_t vehicles) {
  constexpr double pause = 0.005;  // of the module, after each packet
  const std::size_t cycles = (vehicles + wire::kMaxCycleEntries - 1) / wire::kMaxCycleEntries;
  const double packet = wire::loRaAirtime(58, radio.airRate) + pause + 2.0 * 58 * 10 / radio.baud;
  return Seconds{static_cast<double>(cycles + vehicles) * packet};
}

}  // namespace

Faults checkVehicles(const Context& context) {
  Faults faults;
  names(context, faults);
  bodies(context, faults);
  return faults;
}

Faults checkStarts(const Context& context) {
  Faults faults;
  if (!context.zones.anyRunning) return faults;
  for (const VehicleSetup& v : context.site.vehicles) {
    if (!v.start || context.zones.drivable.contains(v.start->position)) continue;
    faults.push_back(vehicleFault(FaultKind::VehicleStartOutside, Severity::Warning, v,
                                  phrase("Core", "Vehicle \"%1\" starts at %2 m, where no zone lets it be.")
                                      .with(v.name, placeText(v.start->position))));
    const Box place{v.start->position, v.start->position};
    if (isPlace(place)) faults.back().place = place;
  }
  return faults;
}

Faults checkRadio(const Context& context) {
  Faults faults;
  const floor::RadioSetup& radio = context.site.radio;
  const auto wrong = [&](const Sentence& sentence) {
    faults.push_back({FaultKind::RadioSettingInvalid, Severity::Error, sentence, {}, {}, {}});
  };
  if (radio.channel < 0 || radio.channel > 31)
    wrong(phrase("Core", "The radio has no channel %1; channels run from 0 to 31.").with(radio.channel));
  if (!isOneOf(floor::kAirRates, radio.airRate))
    wrong(phrase("Core", "The radio knows no air rate of %1 bit/s.").with(figure(radio.airRate, 0)));
  if (!isOneOf(floor::kBauds, radio.baud)) wrong(phrase("Core", "The radio module knows no %1 baud.").with(radio.baud));
  if (!faults.empty() || context.site.vehicles.empty()) return faults;
  const Seconds round = roundOf(radio, context.site.vehicles.size());
  if (round > context.options.longestRound)
    faults.push_back({FaultKind::RadioTooSlow,
                      Severity::Warning,
                      phrase("Core",
                             "At %1 bit/s each of the %2 vehicles is commanded about every %3 s only; it would drive "
                             "slowly and in jerks. Take a higher air rate, or fewer vehicles on one channel.")
                          .with(figure(radio.airRate, 0), context.site.vehicles.size(), figure(round.value(), 1)),
                      {},
                      {},
                      {}});
  return faults;
}

Faults checkEmpty(const Context& context) {
  Faults faults;
  const auto tell = [&](FaultKind kind, const Sentence& sentence) {
    faults.push_back({kind, Severity::Warning, sentence, {}, {}, {}});
  };
  if (context.site.placements.empty() && context.site.looseTags.empty())
    tell(FaultKind::NoTags,
         phrase("Core", "No tile is laid and no loose tag is known: vehicles would not find their way."));
  if (context.site.vehicles.empty())
    tell(FaultKind::NoVehicle, phrase("Core", "The site has no vehicle: routes are checked for a usual one."));
  if (!context.zones.anyRunning)
    tell(FaultKind::NoRunningZone,
         phrase("Core", "The site has no running zone: routes are not checked against where vehicles may be."));
  return faults;
}

}  // namespace tessera::sitecheck
