// Identifiers that cannot be mistaken for one another or for counts.
#pragma once

#include <compare>
#include <cstdint>
#include <functional>

namespace tessera {

template <class Tag, class Rep>
struct Id {
  Rep value{};
  constexpr auto operator<=>(const Id&) const = default;
};

/// A vehicle's address on its radio channel, 1 to 254 (0 is the host, 255 everyone).
using VehicleId = Id<struct VehicleTag, std::uint8_t>;

}  // namespace tessera

template <class Tag, class Rep>
struct std::hash<tessera::Id<Tag, Rep>> {
  std::size_t operator()(const tessera::Id<Tag, Rep>& id) const noexcept { return std::hash<Rep>{}(id.value); }
};
