// Every change of a route as a named step of the document: what the mouse, the table and the menus do alike.
#pragma once

#include <QCoreApplication>
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "floor/route_legs.h"
#include "ui/base/site_document.h"
#include "ui/base/tidy.h"

namespace tessera::ui {

/// Steps that fail (a name that is taken, an edit of a route that is gone) change nothing and say why.
class RouteEdits {
  Q_DECLARE_TR_FUNCTIONS(RouteEdits)
public:
  static constexpr Metres kLeastSpacing{0.01};
  static constexpr Metres kMostSpacing{10.0};
  static constexpr MetresPerSecond kLeastSpeed = floor::kLeastLegSpeed;
  static constexpr MetresPerSecond kMostSpeed = floor::kMostLegSpeed;
  static constexpr std::size_t kMostVertices = 10'000;
  static constexpr int kLongestName = 200;

  explicit RouteEdits(SiteDocument& document) : document_{document} {}

  /// Nullptr: no route of that name.
  [[nodiscard]] const floor::Route* find(const QString& name) const;
  /// "Route 1", or the first number that is free.
  [[nodiscard]] QString freeName() const;

  /// The new route's name.
  Result<QString> add(std::vector<Point> vertices);
  Result<QString> duplicate(const QString& route);
  Result<void> remove(const QString& route);
  /// Error: a name that is empty, too long or taken.
  Result<void> rename(const QString& route, const QString& to);
  Result<void> reverse(const QString& route);
  /// Other routes that begin or end where this one does, in the site's order.
  [[nodiscard]] QStringList touching(const QString& route) const;
  /// The other route becomes part of this one, turned round where it has to be; where both ends of both touch, it comes
  /// behind this one. Error: their ends do not touch.
  Result<void> join(const QString& route, const QString& other);
  /// The part behind the vertex becomes a route of its own, whose name it returns. Error: no vertex between two others.
  Result<QString> split(const QString& route, std::size_t vertex);
  Result<void> setSpacing(const QString& route, Metres spacing, int mergeKey = 0);
  /// mergeKey: see SiteDocument::edit.
  Result<void> moveVertex(const QString& route, std::size_t vertex, Point to, int mergeKey = 0);
  /// Before the vertex of that number; at the end when it is the count.
  Result<void> insertVertex(const QString& route, std::size_t before, Point place);
  /// Error: only two vertices are left.
  Result<void> removeVertex(const QString& route, std::size_t vertex);
  /// Highest speed of the leg from that vertex to the next; nullopt: as ordered.
  Result<void> setLegSpeed(const QString& route, std::size_t leg, std::optional<MetresPerSecond> speed);

private:
  [[nodiscard]] QString freeName(const QString& pattern) const;
  [[nodiscard]] QString freeNameLike(const QString& route, const QString& first, const QString& later) const;
  Result<void> change(const QString& step, const QString& route, const std::function<void(floor::Route&)>& what,
                      int mergeKey = 0);

  SiteDocument& document_;
};

}  // namespace tessera::ui
