#include "ui/route/route_edits.h"

#include <algorithm>

namespace tessera::ui {
namespace {

floor::Route* routeIn(floor::Site& site, const std::string& name) {
  const auto found =
      std::find_if(site.routes.begin(), site.routes.end(), [&](const floor::Route& r) { return r.name == name; });
  return found == site.routes.end() ? nullptr : &*found;
}

tl::unexpected<Error> sentence(const QString& text) { return failure(text.toStdString()); }

}  // namespace

const floor::Route* RouteEdits::find(const QString& name) const {
  return name.isEmpty() ? nullptr : document_.map()->route(name.toStdString());
}

QString RouteEdits::freeName() const { return freeName(tr("Route %1")); }

QString RouteEdits::freeName(const QString& pattern) const {
  for (int n = 1;; ++n) {
    if (QString name = pattern.arg(n); find(name) == nullptr) return name;
  }
}

Result<void> RouteEdits::change(const QString& step, const QString& route,
                                const std::function<void(floor::Route&)>& what, int mergeKey) {
  if (find(route) == nullptr) return sentence(tr("There is no route called “%1” any more.").arg(route));
  return document_.edit(
      step, [&](floor::Site& site) { what(*routeIn(site, route.toStdString())); }, mergeKey);
}

Result<QString> RouteEdits::add(std::vector<Point> vertices) {
  if (vertices.size() < 2) return sentence(tr("A route needs at least two vertices."));
  const QString name = freeName();
  const auto done = document_.edit(tr("Draw %1").arg(name), [&](floor::Site& site) {
    site.routes.push_back({name.toStdString(), std::move(vertices), floor::Route{}.controlSpacing});
  });
  if (!done) return tl::unexpected{done.error()};
  return name;
}

// The name must stay within what a site file holds.
QString RouteEdits::freeNameLike(const QString& route, const QString& first, const QString& later) const {
  QString stem = route;
  while (stem.toUtf8().size() > kLongestName - 30) stem.chop(1);
  QString name = first.arg(stem);
  for (int n = 2; find(name) != nullptr; ++n) name = later.arg(stem, QString::number(n));
  return name;
}

Result<QString> RouteEdits::duplicate(const QString& route) {
  const floor::Route* from = find(route);
  if (from == nullptr) return sentence(tr("There is no route called “%1” any more.").arg(route));
  const QString name = freeNameLike(route, tr("%1 (copy)"), tr("%1 (copy %2)"));
  floor::Route copy = *from;
  copy.name = name.toStdString();
  const auto done = document_.edit(tr("Duplicate %1").arg(route), [&](floor::Site& site) {
    const auto at = std::find_if(site.routes.begin(), site.routes.end(),
                                 [&](const floor::Route& r) { return r.name == route.toStdString(); });
    site.routes.insert(at + 1, copy);
  });
  if (!done) return tl::unexpected{done.error()};
  return name;
}

Result<void> RouteEdits::remove(const QString& route) {
  if (find(route) == nullptr) return {};
  return document_.edit(tr("Delete %1").arg(route), [&](floor::Site& site) {
    std::erase_if(site.routes, [&](const floor::Route& r) { return r.name == route.toStdString(); });
  });
}

Result<void> RouteEdits::rename(const QString& route, const QString& to) {
  const QString name = to.trimmed();
  if (name == route) return {};
  if (name.isEmpty()) return sentence(tr("A route needs a name."));
  if (name.toUtf8().size() > kLongestName) return sentence(tr("This name is too long for a route."));
  if (find(name) != nullptr) return sentence(tr("There is a route called “%1” already.").arg(name));
  return change(tr("Rename %1").arg(route), route, [&](floor::Route& r) { r.name = name.toStdString(); });
}

Result<void> RouteEdits::reverse(const QString& route) {
  return change(tr("Reverse %1").arg(route), route, [](floor::Route& r) { floor::reverse(r); });
}

Result<void> RouteEdits::setSpacing(const QString& route, Metres spacing, int mergeKey) {
  const Metres within{std::clamp(spacing.value(), kLeastSpacing.value(), kMostSpacing.value())};
  return change(
      tr("Space control points of %1").arg(route), route, [&](floor::Route& r) { r.controlSpacing = within; },
      mergeKey);
}

Result<void> RouteEdits::moveVertex(const QString& route, std::size_t vertex, Point to, int mergeKey) {
  return change(
      tr("Move vertex %1 of %2").arg(vertex + 1).arg(route), route,
      [&](floor::Route& r) {
        if (vertex < r.vertices.size()) r.vertices[vertex] = to;
      },
      mergeKey);
}

Result<void> RouteEdits::insertVertex(const QString& route, std::size_t before, Point place) {
  const floor::Route* r = find(route);
  if (r != nullptr && r->vertices.size() >= kMostVertices)
    return sentence(tr("This route has as many vertices as a route may have."));
  return change(tr("Insert vertex into %1").arg(route), route,
                [&](floor::Route& to) { floor::insertVertex(to, before, place); });
}

Result<void> RouteEdits::removeVertex(const QString& route, std::size_t vertex) {
  const floor::Route* r = find(route);
  if (r != nullptr && r->vertices.size() <= 2)
    return sentence(tr("A route needs two vertices; to remove it, delete the route."));
  return change(tr("Delete vertex %1 of %2").arg(vertex + 1).arg(route), route,
                [&](floor::Route& from) { floor::eraseVertex(from, vertex); });
}

Result<void> RouteEdits::setLegSpeed(const QString& route, std::size_t leg, std::optional<MetresPerSecond> speed) {
  if (speed) speed = std::clamp(*speed, kLeastSpeed, kMostSpeed);
  return change(tr("Set speed of leg %1 of %2").arg(leg + 1).arg(route), route,
                [&](floor::Route& r) { floor::setLegSpeed(r, leg, speed); });
}

}  // namespace tessera::ui
