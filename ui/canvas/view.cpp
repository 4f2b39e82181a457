#include "ui/canvas/view.h"

#include <algorithm>
#include <cmath>

namespace tessera::ui {

View::View(QSizeF size, double devicePixelRatio) { resize(size, devicePixelRatio); }

QPointF View::toPixel(Point p) const {
  return {offset_.x() + p.x.value() * scale_, offset_.y() - p.y.value() * scale_};
}

Point View::toSite(QPointF pixel) const {
  return {Metres{(pixel.x() - offset_.x()) / scale_}, Metres{(offset_.y() - pixel.y()) / scale_}};
}

SiteBox View::visible(double margin) const {
  SiteBox box;
  box.add(toSite({-margin, -margin}));
  box.add(toSite({size_.width() + margin, size_.height() + margin}));
  return box;
}

void View::resize(QSizeF size, double devicePixelRatio) {
  size_ = {std::max(size.width(), 1.0), std::max(size.height(), 1.0)};
  ratio_ = devicePixelRatio > 0.0 ? devicePixelRatio : 1.0;
  settle();
}

void View::setContent(const SiteBox& content) {
  content_ = content;
  setScale(scale_);
}

void View::panBy(QPointF pixels) {
  centre_ = centre_ + Offset{Metres{-pixels.x() / scale_}, Metres{pixels.y() / scale_}};
  settle();
}

void View::zoomAbout(QPointF pixel, double factor) {
  if (!(factor > 0.0) || !std::isfinite(factor)) return;
  // From the exact centre, not from the rounded offset: zooming to and fro ends where it began.
  const QPointF arm = pixel - QPointF{size_.width() / 2, size_.height() / 2};
  const double before = scale_;
  scale_ = std::clamp(scale_ * factor, leastScale(), kMostScale);
  const double change = 1.0 / before - 1.0 / scale_;
  centre_ = centre_ + Offset{Metres{arm.x() * change}, Metres{-arm.y() * change}};
  settle();
}

void View::setScale(double pixelsPerMetre) {
  if (!std::isfinite(pixelsPerMetre)) return;
  scale_ = std::clamp(pixelsPerMetre, leastScale(), kMostScale);
  settle();
}

void View::centreOn(Point p) {
  if (!std::isfinite(p.x.value()) || !std::isfinite(p.y.value())) return;
  centre_ = p;
  settle();
}

void View::fit(const SiteBox& box, double margin) {
  if (box.empty()) return;
  const double width = std::max(size_.width() - 2 * margin, size_.width() / 4);
  const double height = std::max(size_.height() - 2 * margin, size_.height() / 4);
  const double across = std::max(box.width().value(), 1e-3);
  const double up = std::max(box.height().value(), 1e-3);
  centre_ = box.centre();
  setScale(std::min(width / across, height / up));
}

double View::leastScale() const {
  if (content_.empty()) return kLeastScale;
  // The floor never becomes smaller than a fifth of the window.
  const double across = std::max(content_.width().value(), 1.0);
  const double up = std::max(content_.height().value(), 1.0);
  return std::max(kLeastScale, 0.2 * std::min(size_.width() / across, size_.height() / up));
}

void View::settle() {
  if (!content_.empty()) {
    const Offset reach{metres(0.4 * size_.width()), metres(0.4 * size_.height())};
    const Point low = content_.low - reach;
    const Point high = content_.high + reach;
    centre_ = {std::clamp(centre_.x, low.x, high.x), std::clamp(centre_.y, low.y, high.y)};
  }
  const auto onDevice = [this](double at) { return std::round(at * ratio_) / ratio_; };
  offset_ = {onDevice(size_.width() / 2 - centre_.x.value() * scale_),
             onDevice(size_.height() / 2 + centre_.y.value() * scale_)};
}

}  // namespace tessera::ui
