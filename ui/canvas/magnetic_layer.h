// What vehicles have learned of the iron in the floor, drawn upon it: by how much it turns a compass, from blue (to the
// right) to orange (to the left), the fainter the less is known.
#pragma once

#include <QCoreApplication>
#include <QPainter>
#include <QString>
#include <memory>
#include <optional>

#include "ui/canvas/layer_picture.h"
#include "ui/canvas/theme.h"
#include "ui/canvas/view.h"

namespace tessera::locate {
class MagneticMap;
}

namespace tessera::ui {

class MagneticLayer {
  Q_DECLARE_TR_FUNCTIONS(tessera::ui::MagneticLayer)
public:
  /// Null: nothing is known.
  void set(std::shared_ptr<const locate::MagneticMap> map);
  [[nodiscard]] const std::shared_ptr<const locate::MagneticMap>& map() const { return map_; }
  void paint(QPainter& painter, const View& view, const CanvasTheme& theme);
  /// In the window's upper left corner, or so many pixels below. Without a map: what to do to get one.
  void paintLegend(QPainter& painter, const View& view, const CanvasTheme& theme, double below) const;
  /// What is known of the place: deviation, its doubt, visits. Empty: nothing.
  [[nodiscard]] QString textAt(Point place) const;
  /// The deviation, in degrees, that has the strongest colour.
  [[nodiscard]] double fullDegrees() const;

private:
  std::shared_ptr<const locate::MagneticMap> map_;
  mutable std::optional<double> full_;  ///< found when it is first asked for: maps come often, and mostly unseen
  LayerPicture picture_;
};

}  // namespace tessera::ui
