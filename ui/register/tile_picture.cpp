#include "ui/register/tile_picture.h"

#include <QPainter>
#include <algorithm>

#include "floor/laid_tile.h"
#include "ui/canvas/theme.h"

namespace tessera::ui {
namespace {

constexpr int kFlashMs = 350;

}  // namespace

TilePicture::TilePicture(QWidget* parent) : QWidget{parent} {
  setObjectName(QStringLiteral("tilePicture"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  flashEnd_.setSingleShot(true);
  flashEnd_.setInterval(kFlashMs);
  connect(&flashEnd_, &QTimer::timeout, this, [this] {
    flash_ = Flash::None;
    update();
  });
}

QSize TilePicture::sizeHint() const {
  const int side = fontMetrics().height() * 8;
  return {side, side};
}

QSize TilePicture::minimumSizeHint() const {
  const int side = fontMetrics().height() * 6;
  return {side, side};
}

void TilePicture::setTile(const floor::TileType& type, const floor::Tile& tile, int quarterTurns, std::size_t tag) {
  shown_ = Shown{type, tile, quarterTurns, tag};
  update();
}

void TilePicture::clear() {
  shown_.reset();
  update();
}

void TilePicture::flash(Flash flash) {
  flash_ = flash;
  flashEnd_.start();
  update();
}

void TilePicture::paintEvent(QPaintEvent* /*event*/) {
  if (!shown_) return;
  const CanvasTheme theme{palette()};
  QPainter painter{this};
  painter.setRenderHint(QPainter::Antialiasing);
  const floor::Placement laid{{}, {}, shown_->turns};
  const Box box = floor::boxOf(laid, shown_->type);
  const double room = 4.0;
  const double scale = std::min((width() - 2 * room) / (box.high.x - box.low.x).value(),
                                (height() - 2 * room) / (box.high.y - box.low.y).value());
  const Point middle = middleOf(box);
  const auto pixel = [&](Point p) {
    return QPointF{width() / 2.0 + (p.x - middle.x).value() * scale, height() / 2.0 - (p.y - middle.y).value() * scale};
  };
  QColor ground = theme.tile;
  if (flash_ == Flash::Good) ground = QColor{0x22, 0xa0, 0x5a};
  if (flash_ == Flash::Bad) ground = theme.fault;
  painter.setPen(QPen{theme.seam, 2.0});
  painter.setBrush(ground);
  painter.drawRoundedRect(QRectF{pixel(box.low), pixel(box.high)}.normalized(), 4, 4);

  const double dot = std::clamp(0.28 * shown_->type.pitch.value() * scale, 3.0, 24.0);
  const auto offsets = tagOffsets(shown_->type);
  for (std::size_t n = 0; n < offsets.size(); ++n) {
    const QPointF at = pixel(placeOn(laid, offsets[n]));
    const bool registered = n < shown_->tile.uids.size() && !shown_->tile.uids[n].empty();
    painter.setPen(QPen{registered ? theme.tag : theme.missingTag, 2.0});
    painter.setBrush(registered ? QBrush{theme.tag} : QBrush{Qt::NoBrush});
    painter.drawEllipse(at, dot * 0.7, dot * 0.7);
    if (n != shown_->tag) continue;
    painter.setPen(QPen{theme.accent, std::max(3.0, dot * 0.3)});
    QColor lit = theme.accent;
    lit.setAlpha(90);
    painter.setBrush(lit);
    painter.drawEllipse(at, dot * 1.25, dot * 1.25);
  }
}

}  // namespace tessera::ui
