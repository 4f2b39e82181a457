// Two routes made one, and one made two.
#include <algorithm>

#include "ui/route/route_edits.h"

namespace tessera::ui {
namespace {

constexpr Metres kTouching{0.001};  // what is drawn lies on whole millimetres

enum class Joint { None, BehindAsIs, BehindReversed, BeforeAsIs, BeforeReversed };

Joint jointOf(const floor::Route& route, const floor::Route& other) {
  const auto touch = [](Point a, Point b) { return distance(a, b) <= kTouching; };
  if (route.vertices.size() < 2 || other.vertices.size() < 2) return Joint::None;
  if (touch(route.vertices.back(), other.vertices.front())) return Joint::BehindAsIs;
  if (touch(route.vertices.back(), other.vertices.back())) return Joint::BehindReversed;
  if (touch(route.vertices.front(), other.vertices.back())) return Joint::BeforeAsIs;
  if (touch(route.vertices.front(), other.vertices.front())) return Joint::BeforeReversed;
  return Joint::None;
}

}  // namespace

QStringList RouteEdits::touching(const QString& route) const {
  QStringList names;
  const floor::Route* own = find(route);
  if (own == nullptr) return names;
  for (const floor::Route& other : document_.site().routes)
    if (&other != own && jointOf(*own, other) != Joint::None) names << QString::fromStdString(other.name);
  return names;
}

Result<void> RouteEdits::join(const QString& route, const QString& other) {
  const floor::Route* own = find(route);
  const floor::Route* more = find(other);
  const Joint joint = own != nullptr && more != nullptr && own != more ? jointOf(*own, *more) : Joint::None;
  if (joint == Joint::None) return failure(tr("“%1” and “%2” have no end in common.").arg(route, other).toStdString());
  if (own->vertices.size() + more->vertices.size() - 1 > kMostVertices)
    return failure(tr("Together they would have more vertices than a route may have.").toStdString());
  floor::Route first = *own;
  floor::Route second = *more;
  if (joint == Joint::BehindReversed || joint == Joint::BeforeReversed) floor::reverse(second);
  if (joint == Joint::BeforeAsIs || joint == Joint::BeforeReversed) std::swap(first, second);
  floor::append(first, second);
  return document_.edit(tr("Join %1 with %2").arg(route, other), [&](floor::Site& site) {
    for (floor::Route& r : site.routes) {
      if (r.name != route.toStdString()) continue;
      r.vertices = first.vertices;
      r.legSpeeds = first.legSpeeds;
    }
    std::erase_if(site.routes, [&](const floor::Route& r) { return r.name == other.toStdString(); });
  });
}

Result<QString> RouteEdits::split(const QString& route, std::size_t vertex) {
  const floor::Route* own = find(route);
  if (own == nullptr) return failure(tr("There is no route called “%1” any more.").arg(route).toStdString());
  if (vertex == 0 || vertex + 1 >= own->vertices.size())
    return failure(tr("A route is split at a vertex between two others.").toStdString());
  QString name = freeNameLike(route, tr("%1 (part 2)"), tr("%1 (part 2, %2)"));
  const auto done = document_.edit(tr("Split %1").arg(route), [&](floor::Site& site) {
    const auto first = std::find_if(site.routes.begin(), site.routes.end(),
                                    [&](const floor::Route& r) { return r.name == route.toStdString(); });
    floor::Route rest = floor::cutAt(*first, vertex);
    rest.name = name.toStdString();
    site.routes.insert(first + 1, std::move(rest));
  });
  if (!done) return tl::unexpected{done.error()};
  return name;
}

}  // namespace tessera::ui
