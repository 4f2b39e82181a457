#include "sitecheck/fault.h"

#include <array>

namespace tessera::sitecheck {
namespace {

constexpr std::array<std::string_view, kFaultKinds> kCodes{"tile-type-twice",
                                                           "tile-twice",
                                                           "tile-laid-twice",
                                                           "tile-unknown",
                                                           "tile-type-unknown",
                                                           "too-many-uids",
                                                           "place-no-number",
                                                           "uid-twice",
                                                           "tile-unregistered",
                                                           "tile-partly-registered",
                                                           "tiles-overlap",
                                                           "tile-off-lattice",
                                                           "zone-twice",
                                                           "zone-without-area",
                                                           "zone-crosses-itself",
                                                           "zone-repeats-point",
                                                           "zone-without-speed",
                                                           "zone-without-direction",
                                                           "zone-gap",
                                                           "zones-contradict",
                                                           "zone-unreachable",
                                                           "route-twice",
                                                           "route-too-short",
                                                           "route-repeats-point",
                                                           "route-leaves-running-zone",
                                                           "route-crosses-no-go",
                                                           "route-against-one-way",
                                                           "route-too-close",
                                                           "route-too-tight",
                                                           "route-faster-than-zone",
                                                           "route-without-tags",
                                                           "vehicle-address-twice",
                                                           "vehicle-address-invalid",
                                                           "vehicle-twice",
                                                           "vehicle-without-key",
                                                           "vehicle-key-shared",
                                                           "vehicle-without-readers",
                                                           "vehicle-without-footprint",
                                                           "vehicle-start-outside",
                                                           "radio-setting-invalid",
                                                           "radio-too-slow",
                                                           "no-tags",
                                                           "no-vehicle",
                                                           "no-running-zone"};
static_assert(!kCodes.back().empty());

}  // namespace

std::string_view codeOf(FaultKind kind) { return kCodes.at(static_cast<std::size_t>(kind)); }
std::string_view codeOf(Severity severity) { return severity == Severity::Error ? "error" : "warning"; }
std::string_view codeOf(ObjectKind kind) {
  constexpr std::array<std::string_view, 6> names{"tile-type", "tile", "tag", "zone", "route", "vehicle"};
  return names.at(static_cast<std::size_t>(kind));
}

}  // namespace tessera::sitecheck
