// Which part of the site the window shows, and how large: a value that turns site points into pixels and back.
#pragma once

#include <QPointF>
#include <QSizeF>

#include "ui/canvas/site_box.h"

namespace tessera::ui {

/// Pixels are logical ones, from the upper left corner, y down; the site's y points up. The picture lies on whole
/// device pixels, so that two views of one scale differ by a whole number of them and a drawn one can be shifted.
class View {
public:
  static constexpr double kLeastScale = 0.002;   ///< pixels per metre: 1000 km on 2000 pixels
  static constexpr double kMostScale = 10000.0;  ///< pixels per metre: ten pixels a millimetre

  View() = default;
  View(QSizeF size, double devicePixelRatio);

  [[nodiscard]] QSizeF size() const { return size_; }
  [[nodiscard]] double devicePixelRatio() const { return ratio_; }
  /// Pixels per metre.
  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] Point centre() const { return centre_; }
  [[nodiscard]] QPointF toPixel(Point p) const;
  [[nodiscard]] Point toSite(QPointF pixel) const;
  [[nodiscard]] double pixels(Metres length) const { return length.value() * scale_; }
  [[nodiscard]] Metres metres(double pixels) const { return Metres{pixels / scale_}; }
  /// What the window shows, `margin` pixels more on every side.
  [[nodiscard]] SiteBox visible(double margin = 0.0) const;

  /// The centre stays.
  void resize(QSizeF size, double devicePixelRatio);
  /// What the floor covers: it bounds zooming out and keeps panning from losing it. Empty: no bounds but the constants.
  void setContent(const SiteBox& content);
  /// Moves the picture by so many pixels.
  void panBy(QPointF pixels);
  /// The site point under the pixel stays there.
  void zoomAbout(QPointF pixel, double factor);
  void setScale(double pixelsPerMetre);
  void centreOn(Point p);
  /// The whole box in the window, `margin` pixels free on every side.
  void fit(const SiteBox& box, double margin);

  bool operator==(const View& o) const {
    return size_ == o.size_ && ratio_ == o.ratio_ && scale_ == o.scale_ && offset_ == o.offset_;
  }

private:
  [[nodiscard]] double leastScale() const;
  void settle();

  QSizeF size_{1.0, 1.0};
  double ratio_ = 1.0;
  double scale_ = 100.0;
  Point centre_;
  QPointF offset_;  ///< pixel of the site's origin
  SiteBox content_;
};

}  // namespace tessera::ui
