// Every change of a route as a named step of the document: what the mouse, the table and the menus do alike.
#pragma once

#include <QCoreApplication>
#include <QString>
#include <optional>
#include <vector>

#include "ui/base/site_document.h"

namespace tessera::ui {

/// Steps that fail (a name that is taken, an edit of a route that is gone) change nothing and say why.
class RouteEdits {
  Q_DECLARE_TR_FUNCTIONS(RouteEdits)
public:
  static constexpr Metres kFarthest{100'000.0};  ///< coordinates that a site file may hold
  static constexpr Metres kLeastSpacing{0.01};
  static constexpr Metres kMostSpacing{10.0};
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
  Result<void> setSpacing(const QString& route, Metres spacing, int mergeKey = 0);
  /// mergeKey: see SiteDocument::edit.
  Result<void> moveVertex(const QString& route, std::size_t vertex, Point to, int mergeKey = 0);
  /// Before the vertex of that number; at the end when it is the count.
  Result<void> insertVertex(const QString& route, std::size_t before, Point place);
  /// Error: only two vertices are left.
  Result<void> removeVertex(const QString& route, std::size_t vertex);

private:
  [[nodiscard]] QString freeName(const QString& pattern) const;
  Result<void> change(const QString& step, const QString& route, const std::function<void(floor::Route&)>& what,
                      int mergeKey = 0);

  SiteDocument& document_;
};

/// To the millimetre within what a site file holds: what is drawn can be read in the table.
[[nodiscard]] Point tidy(Point p);

}  // namespace tessera::ui
