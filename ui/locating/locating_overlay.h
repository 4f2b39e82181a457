// How a vehicle is located, drawn upon the floor: the guesses or the ellipse of the doubt, the way on which it is
// expected until a command acts, the point that it is led to, and what its readers read last.
#pragma once

#include <QCoreApplication>
#include <memory>
#include <vector>

#include "supervisor/locating_view.h"
#include "supervisor/snapshot.h"
#include "ui/canvas/canvas_overlay.h"

namespace tessera::ui {

enum class DoubtShape { Guesses, Ellipse, Both };

class LocatingOverlay : public CanvasOverlay {
  Q_DECLARE_TR_FUNCTIONS(tessera::ui::LocatingOverlay)
public:
  static constexpr Seconds kOldestRead{10.0};

  /// Of each reader the last read; null: draws nothing.
  void show(std::shared_ptr<const supervisor::LocatingView> view, std::vector<supervisor::ReadView> reads, Seconds now);
  void setShape(DoubtShape shape) { shape_ = shape; }
  [[nodiscard]] DoubtShape shape() const { return shape_; }
  [[nodiscard]] bool empty() const { return !view_; }

  void paint(QPainter& painter, const View& view, const CanvasTheme& theme) override;
  [[nodiscard]] QRegion extent(const View& view, const QFont& font) const override;

private:
  [[nodiscard]] bool showsGuesses() const;
  [[nodiscard]] bool showsEllipse() const;
  [[nodiscard]] QString readText(const supervisor::ReadView& read) const;
  void paintDoubt(QPainter& painter, const View& view, const CanvasTheme& theme) const;
  void paintWay(QPainter& painter, const View& view, const CanvasTheme& theme) const;
  void paintReads(QPainter& painter, const View& view, const CanvasTheme& theme) const;

  std::shared_ptr<const supervisor::LocatingView> view_;
  std::vector<supervisor::ReadView> reads_;
  Seconds now_;
  DoubtShape shape_ = DoubtShape::Both;
};

/// The last read of each reader that is not too old, with a known place, oldest first.
[[nodiscard]] std::vector<supervisor::ReadView> lastReads(const supervisor::VehicleView& vehicle, Seconds now);

}  // namespace tessera::ui
