// What can be done to the picture beneath the floor: each a named step of the document.
#pragma once

#include <QCoreApplication>
#include <QString>

#include "ui/base/site_document.h"

namespace tessera::ui {

class BackdropEdits {
  Q_DECLARE_TR_FUNCTIONS(tessera::ui::BackdropEdits)
public:
  explicit BackdropEdits(SiteDocument& document) : document_{document} {}

  /// Null: the site has none.
  [[nodiscard]] const floor::Backdrop* find() const;
  /// A new picture lies with its lower left corner at the site's origin, a centimetre a pixel; one that takes the place
  /// of another lies as that did. Error: it is none that can be shown; nothing has changed then.
  Result<void> put(const QString& file, std::string bytes);
  Result<void> remove();
  // mergeKey: see SiteDocument::edit().
  Result<void> move(Point origin, int mergeKey = 0);
  Result<void> turn(Radians turn, int mergeKey = 0);
  Result<void> setPixel(Metres pixel, int mergeKey = 0);
  Result<void> setOpacity(double opacity, int mergeKey = 0);
  /// What lies between two places of the picture is truly so long: it grows or shrinks about the first one. Error: the
  /// two are one, or the scale is none that a site file holds.
  Result<void> scale(Point from, Point to, Metres truly);

private:
  Result<void> change(const QString& step, const std::function<void(floor::Backdrop&)>& what, int mergeKey = 0);
  SiteDocument& document_;
};

}  // namespace tessera::ui
