// A sheet with the map of a site to scale: title, floor, legend. Drawn with any painter, so that it can become a
// picture of dots, of lines, or paper.
#pragma once

#include <QPainter>
#include <QString>

#include "floor/site_map.h"
#include "ui/canvas/backdrop_picture.h"
#include "ui/canvas/floor_index.h"
#include "ui/canvas/site_box.h"

namespace tessera::ui {

struct SheetWish {
  double scale = 50.0;  ///< so many metres of the floor are one metre of paper
  bool tags = true;
  bool serials = true;
  bool zones = true;
  bool routes = true;
  bool legend = true;
  bool plan = true;  ///< the picture of the building beneath, where the site has one
  QString date;      ///< stands in the title; empty: none
};

/// The sheet's unit of length: so many make a millimetre. Fonts and lines have their usual size in it.
inline constexpr double kUnitsPerMm = 96.0 / 25.4;

class MapSheet {
public:
  /// Title and legend take the application's language and font.
  MapSheet(std::shared_ptr<const floor::SiteMap> map, const SheetWish& wish);

  /// In units.
  [[nodiscard]] QSizeF size() const { return size_; }
  [[nodiscard]] QSizeF millimetres() const { return size_ / kUnitsPerMm; }
  /// Places that are drawn one by one; what makes a file of lines large.
  [[nodiscard]] std::size_t places() const;
  /// False: every tile is too small at this scale for its serial number, and none is drawn.
  [[nodiscard]] bool hasRoomForSerials() const;
  /// The painter's device has 96 logical dots per inch, so that its text has the size that was reckoned with.
  void paint(QPainter& painter) const;

private:
  void paintTitle(QPainter& painter) const;
  void paintPlan(QPainter& painter, const class View& view, const QRectF& area) const;
  void paintFloor(QPainter& painter, const QRectF& area) const;
  void paintTiles(QPainter& painter, const class View& view, const class CanvasTheme& theme) const;
  void paintLegend(QPainter& painter, const QRectF& area) const;
  [[nodiscard]] int legendRows() const;

  std::shared_ptr<const floor::SiteMap> map_;
  SheetWish wish_;
  std::shared_ptr<const BackdropPicture> plan_;  ///< null: none is drawn
  FloorIndex index_;
  SiteBox shown_;
  QSizeF size_;
  double line_;   ///< height of a line of text
  double above_;  ///< the floor, for the title
};

}  // namespace tessera::ui
