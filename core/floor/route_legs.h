// A route's vertices and the speeds of the legs between them, kept in step: whoever changes a route's vertices does it
// by these, so that each speed stays with the way that it was given for.
#pragma once

#include "floor/site.h"

namespace tessera::floor {

/// What a site file can hold.
inline constexpr MetresPerSecond kLeastLegSpeed{0.001};
inline constexpr MetresPerSecond kMostLegSpeed{20.0};

[[nodiscard]] inline std::size_t legCount(const Route& route) {
  return route.vertices.empty() ? 0 : route.vertices.size() - 1;
}

/// Highest speed of a leg, from vertex `leg` to the next; nullopt: as ordered.
[[nodiscard]] std::optional<MetresPerSecond> legSpeed(const Route& route, std::size_t leg);
/// Of each leg of Polyline{route.vertices}, which drops legs of no length.
[[nodiscard]] std::vector<std::optional<MetresPerSecond>> legSpeedsOfLine(const Route& route);

/// No such leg: nothing changes.
void setLegSpeed(Route& route, std::size_t leg, std::optional<MetresPerSecond> speed);
/// Before the vertex of that number, at the end when it is the count. Both parts of a leg that is cut keep its speed.
void insertVertex(Route& route, std::size_t before, Point place);
/// Of two legs that become one the lower speed holds.
void eraseVertex(Route& route, std::size_t vertex);
void reverse(Route& route);
/// The second one's first vertex is the first one's last, which stays.
void append(Route& route, const Route& behind);
/// Cuts the route at a vertex between two others; what lies behind is the result, a route of the same name.
[[nodiscard]] Route cutAt(Route& route, std::size_t vertex);
/// Drops all vertices but these, of which each is one of the route's and in its order; a leg is known by its end.
void keepVertices(Route& route, const std::vector<Point>& kept);
/// As few speeds as say the same: none where no leg has one.
void tidyLegSpeeds(Route& route);

}  // namespace tessera::floor
