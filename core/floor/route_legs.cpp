#include "floor/route_legs.h"

#include <algorithm>

namespace tessera::floor {
namespace {

using Speed = std::optional<MetresPerSecond>;

// One speed for each leg, to work on; tidyLegSpeeds() ends the work.
std::vector<Speed>& everySpeed(Route& route) {
  route.legSpeeds.resize(legCount(route));
  return route.legSpeeds;
}

std::ptrdiff_t at(std::size_t index) { return static_cast<std::ptrdiff_t>(index); }

Speed lower(Speed a, Speed b) { return !a || (b && *b < *a) ? b : a; }

}  // namespace

Speed legSpeed(const Route& route, std::size_t leg) {
  return leg < route.legSpeeds.size() ? route.legSpeeds[leg] : std::nullopt;
}

std::vector<Speed> legSpeedsOfLine(const Route& route) {
  std::vector<Speed> speeds;
  const Point* last = nullptr;
  for (std::size_t n = 0; n < route.vertices.size(); ++n) {
    const Point& here = route.vertices[n];
    if (last != nullptr && distance(*last, here) <= Metres{0.0}) continue;
    if (last != nullptr) speeds.push_back(legSpeed(route, n - 1));
    last = &here;
  }
  return speeds;
}

void tidyLegSpeeds(Route& route) {
  everySpeed(route);
  if (std::none_of(route.legSpeeds.begin(), route.legSpeeds.end(), [](Speed s) { return s.has_value(); }))
    route.legSpeeds.clear();
}

void setLegSpeed(Route& route, std::size_t leg, Speed speed) {
  if (leg >= legCount(route)) return;
  everySpeed(route)[leg] = speed;
  tidyLegSpeeds(route);
}

void insertVertex(Route& route, std::size_t before, Point place) {
  const std::size_t where = std::min(before, route.vertices.size());
  // A new leg at either end is nobody's part.
  std::vector<Speed>& speeds = everySpeed(route);
  if (!route.vertices.empty()) {
    const bool between = where > 0 && where < route.vertices.size();
    const Speed inherited = between ? speeds[where - 1] : std::nullopt;
    speeds.insert(speeds.begin() + at(std::min(where, speeds.size())), inherited);
  }
  route.vertices.insert(route.vertices.begin() + at(where), place);
  tidyLegSpeeds(route);
}

void eraseVertex(Route& route, std::size_t vertex) {
  if (vertex >= route.vertices.size()) return;
  std::vector<Speed>& speeds = everySpeed(route);
  if (vertex > 0 && vertex < speeds.size()) speeds[vertex - 1] = lower(speeds[vertex - 1], speeds[vertex]);
  if (!speeds.empty()) speeds.erase(speeds.begin() + at(std::min(vertex, speeds.size() - 1)));
  route.vertices.erase(route.vertices.begin() + at(vertex));
  tidyLegSpeeds(route);
}

void reverse(Route& route) {
  std::vector<Speed>& speeds = everySpeed(route);
  std::reverse(speeds.begin(), speeds.end());
  std::reverse(route.vertices.begin(), route.vertices.end());
  tidyLegSpeeds(route);
}

void append(Route& route, const Route& behind) {
  if (behind.vertices.empty()) return;
  std::vector<Speed>& speeds = everySpeed(route);
  for (std::size_t leg = 0; leg < legCount(behind); ++leg) speeds.push_back(legSpeed(behind, leg));
  route.vertices.insert(route.vertices.end(), behind.vertices.begin() + 1, behind.vertices.end());
  tidyLegSpeeds(route);
}

Route cutAt(Route& route, std::size_t vertex) {
  Route rest = route;
  if (vertex >= route.vertices.size()) return rest;
  everySpeed(route);
  everySpeed(rest);
  rest.vertices.erase(rest.vertices.begin(), rest.vertices.begin() + at(vertex));
  rest.legSpeeds.erase(rest.legSpeeds.begin(), rest.legSpeeds.begin() + at(vertex));
  route.vertices.resize(vertex + 1);
  route.legSpeeds.resize(vertex);
  tidyLegSpeeds(route);
  tidyLegSpeeds(rest);
  return rest;
}

void keepVertices(Route& route, const std::vector<Point>& kept) {
  std::vector<Speed> speeds;
  for (std::size_t n = 0, next = 0; n < route.vertices.size() && next < kept.size(); ++n) {
    if (route.vertices[n] != kept[next]) continue;
    if (next++ > 0) speeds.push_back(legSpeed(route, n - 1));
  }
  route.vertices = kept;
  route.legSpeeds = std::move(speeds);
  tidyLegSpeeds(route);
}

}  // namespace tessera::floor
