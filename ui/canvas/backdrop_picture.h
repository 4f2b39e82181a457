// The drawing of the building beneath the floor: decoded once, kept at halved sizes, so that painting costs what is
// seen of it, however large it is.
#pragma once

#include <QImage>
#include <QPainter>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "base/sentence.h"
#include "floor/site.h"
#include "ui/canvas/view.h"

namespace tessera::ui {

class BackdropPicture {
public:
  static constexpr int kMostMegapixels = 30;

  /// The decoded picture. Asked again for the same bytes it is the same one, as long as somebody holds it. Null bytes
  /// are a damaged picture.
  [[nodiscard]] static std::shared_ptr<const BackdropPicture> of(const std::shared_ptr<const std::string>& bytes);
  explicit BackdropPicture(const std::string& bytes);

  /// Why it cannot be shown: "The picture is damaged." Its size is empty then.
  [[nodiscard]] const std::optional<Sentence>& fault() const { return fault_; }
  [[nodiscard]] QSize size() const { return levels_.empty() ? QSize{} : levels_.front().size(); }
  /// The smallest one that has at least as many pixels as are asked for; scale: device pixels for a pixel of the whole.
  [[nodiscard]] const QImage& level(double scale) const;
  [[nodiscard]] std::size_t levels() const { return levels_.size(); }

private:
  std::vector<QImage> levels_;  ///< each half as wide and high as the one before
  std::optional<Sentence> fault_;
};

/// On the floor, counter-clockwise from the lower left one.
[[nodiscard]] std::array<Point, 4> cornersOf(const floor::Backdrop& place, QSize pixels);

/// Into the painter's clip, which `seen` (logical pixels) contains.
void paintBackdrop(QPainter& painter, const View& view, const floor::Backdrop& place, const BackdropPicture& picture,
                   const QRectF& seen);

}  // namespace tessera::ui
