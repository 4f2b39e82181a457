#include "ui/register/register_tool.h"

#include <algorithm>
#include <cmath>

namespace tessera::ui {
namespace {

constexpr int kToolFlashMs = 400;
constexpr double kReachPixels = 30.0;

}  // namespace

RegisterTool::RegisterTool(Registrar& registrar, ScanPage& page, QObject* parent)
    : CanvasTool{parent}, registrar_{registrar}, page_{page} {
  flash_.setSingleShot(true);
  flash_.setInterval(kToolFlashMs);
  connect(&flash_, &QTimer::timeout, this, [this] {
    done_.reset();
    Q_EMIT changed();
  });
  connect(&registrar_, &Registrar::accepted, this, [this](const floor::TagUid& uid) {
    done_ = registrar_.document().map()->find(uid);
    flash_.start();
  });
  connect(&registrar_, &Registrar::changed, this, &RegisterTool::touch);
}

void RegisterTool::touch() {
  marked_.reset();
  Q_EMIT changed();
  Q_EMIT hintChanged(hint());
}

std::optional<Point> RegisterTool::mark(const scan::PlaceName& place) {
  const floor::Tile* tile = tileOf(registrar_.document().site(), place.serial);
  marked_.reset();
  if (tile != nullptr && place.tag < tile->uids.size())
    marked_ = registrar_.document().map()->find(tile->uids[place.tag]);
  Q_EMIT changed();
  return marked_;
}

bool RegisterTool::mousePressed(const ToolMouse& /*mouse*/, const CanvasScene& /*scene*/) { return false; }
bool RegisterTool::mouseMoved(const ToolMouse& /*mouse*/, const CanvasScene& /*scene*/) { return false; }
bool RegisterTool::mouseReleased(const ToolMouse& /*mouse*/, const CanvasScene& /*scene*/) { return false; }

bool RegisterTool::mouseDoubleClicked(const ToolMouse& mouse, const CanvasScene& scene) {
  const auto& registration = registrar_.registration();
  if (mouse.button != Qt::LeftButton || !registration) return false;
  const scan::Stop* nearest = nullptr;
  double least = kReachPixels;
  for (const scan::Stop& stop : registration->walk()) {
    if (!stop.place) continue;
    const double away = scene.view.pixels(distance(*stop.place, mouse.place));
    if (away > least) continue;
    least = away;
    nearest = &stop;
  }
  if (nearest != nullptr) registrar_.goTo(scan::nameOf(registration->site(), *nearest));
  return true;
}

bool RegisterTool::keyPressed(QKeyEvent& event, const CanvasScene& /*scene*/) { return page_.takeKey(event); }
bool RegisterTool::keyReleased(QKeyEvent& /*event*/, const CanvasScene& /*scene*/) { return false; }

bool RegisterTool::wantsShortcut(const QKeyEvent& event) const {
  return event.key() == Qt::Key_Escape || (registrar_.state() != Registrar::State::Idle && ScanPage::wantsKey(event));
}

bool RegisterTool::cancel() { return false; }

QString RegisterTool::hint() const {
  if (registrar_.state() == Registrar::State::Idle) return tr("Choose the reader in the panel and press Start.");
  if (!registrar_.place()) return tr("Every place is registered or skipped. Esc: leave.");
  return tr(
      "Hold the lit tag to the reader. Backspace: one back. Del: skip it. Double-click a tag: go on there. Esc: "
      "leave.");
}

void RegisterTool::paint(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme) {
  painter.setRenderHint(QPainter::Antialiasing);
  const View& view = scene.view;
  const auto ring = [&](Point at, QColor colour, double radius, double width, bool filled) {
    painter.setPen(QPen{theme.halo, width + 3.0});
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(view.toPixel(at), radius, radius);
    painter.setPen(QPen{colour, width});
    painter.setBrush(filled ? QBrush{colour} : QBrush{Qt::NoBrush});
    painter.drawEllipse(view.toPixel(at), radius, radius);
  };
  const double near = std::clamp(view.pixels(scene.floor.pitch()) * 0.35, 7.0, 40.0);
  if (done_) ring(*done_, QColor{0x22, 0xa0, 0x5a}, near, 2.0, true);
  if (marked_) ring(*marked_, theme.fault, near * 1.3, 4.0, false);
  const auto next = registrar_.point();
  if (!next) return;
  scene.floor.forEachTile(SiteBox{*next, *next}, [&](const FloorIndex::Tile& tile) {
    const QRectF box = QRectF{view.toPixel(tile.box.low), view.toPixel(tile.box.high)}.normalized();
    painter.setPen(QPen{theme.accent, 3.0});
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(box);
  });
  ring(*next, theme.accent, near, 4.0, false);
}

}  // namespace tessera::ui
