// Every change of a zone as a named step of the document: what the mouse, the table and the menus do alike.
#pragma once

#include <QCoreApplication>
#include <QString>
#include <vector>

#include "ui/base/site_document.h"

namespace tessera::ui {

/// Steps that fail (a name that is taken, an edit of a zone that is gone) change nothing and say why. Of two zones of
/// one name, which a site may hold, the first is meant.
class ZoneEdits {
  Q_DECLARE_TR_FUNCTIONS(ZoneEdits)
public:
  static constexpr std::size_t kMostCorners = 10'000;
  static constexpr int kLongestName = 200;
  static constexpr MetresPerSecond kLeastSpeed{0.01};
  static constexpr MetresPerSecond kMostSpeed{20.0};
  static constexpr MetresPerSecond kUsualSpeed{0.10};  ///< of a new slow zone: half a usual drive's

  explicit ZoneEdits(SiteDocument& document) : document_{document} {}

  /// Nullptr: no zone of that name.
  [[nodiscard]] const floor::Zone* find(const QString& name) const;

  /// The new zone's name: its kind and the first number that is free. Error: it encloses no floor.
  Result<QString> add(floor::ZoneKind kind, std::vector<Point> outline);
  Result<QString> duplicate(const QString& zone);
  Result<void> remove(const QString& zone);
  /// Error: a name that is empty, too long or taken.
  Result<void> rename(const QString& zone, const QString& to);
  /// A slow zone gets a speed and a one-way zone a direction where it has none; what the kind does not need goes.
  Result<void> setKind(const QString& zone, floor::ZoneKind kind);
  Result<void> setSpeed(const QString& zone, MetresPerSecond speed, int mergeKey = 0);
  Result<void> setDirection(const QString& zone, Radians direction, int mergeKey = 0);
  /// mergeKey: see SiteDocument::edit.
  Result<void> moveCorner(const QString& zone, std::size_t corner, Point to, int mergeKey = 0);
  /// The whole zone.
  Result<void> move(const QString& zone, Offset by, int mergeKey = 0);
  /// Before the corner of that number; at the end when it is the count.
  Result<void> insertCorner(const QString& zone, std::size_t before, Point place);
  /// Error: only three corners are left.
  Result<void> removeCorner(const QString& zone, std::size_t corner);

private:
  [[nodiscard]] QString freeName(const QString& stem) const;
  Result<void> change(const QString& step, const QString& zone, const std::function<void(floor::Zone&)>& what,
                      int mergeKey = 0);

  SiteDocument& document_;
};

}  // namespace tessera::ui
