// What lies under the vehicles: the floor and their trails, as a picture that is kept. It is larger than the window, so
// that panning shifts it and only what comes into view is drawn. Where all of it has to be drawn, that is done slice by
// slice beside what is shown; until it is complete the old picture stands in, scaled.
#pragma once

#include <QImage>
#include <chrono>
#include <optional>
#include <unordered_map>

#include "ui/canvas/floor_painter.h"
#include "ui/canvas/trail.h"

namespace tessera::ui {

struct TrailMark {
  VehicleId vehicle;
  const Trail* trail = nullptr;
  QColor colour;
};

/// All that the picture shows.
struct Ground {
  View view;
  FloorScene floor;
  CanvasTheme theme;
  std::vector<TrailMark> trails;
  Seconds now;  ///< the trails' clock
};

class GroundLayer {
public:
  static constexpr std::chrono::milliseconds kForever = std::chrono::milliseconds::max();

  /// Nothing of what is shown holds any more: the next picture is drawn in one go.
  void clear();
  /// The floor looks different; what is shown stays until the new picture is complete.
  void invalidate() { ++floorVersion_; }
  /// Trails have aged, or are others.
  void fade() { ++trailVersion_; }
  /// Before each painting: shifts the picture to the view and lengthens the trails.
  void prepare(const Ground& ground);
  /// Draws on what is not settled, some milliseconds long. True: another picture is shown from now on, all of it.
  bool work(const Ground& ground, std::chrono::milliseconds patience);
  /// Another picture has been begun and is not shown yet.
  [[nodiscard]] bool isWorking() const { return job_.has_value(); }
  /// What is shown is what was asked for.
  [[nodiscard]] bool settled() const { return !job_ && !wantsJob(); }
  /// Puts the part of it that the rectangle (logical pixels of the window) shows.
  void blit(QPainter& painter, const QRect& rect, QColor outside) const;
  /// How often a whole floor was drawn, for tests and benchmarks.
  [[nodiscard]] int redraws() const { return redraws_; }

private:
  struct Picture {
    View view;
    QImage floor;
    QImage whole;  ///< with trails
    std::unordered_map<VehicleId, Seconds> trailsUpTo;
    int floorVersion = 0;
    int trailVersion = 0;
  };
  struct Job {
    Picture picture;
    FloorScene scene;
    CanvasTheme theme;
    int rows = 0;  ///< of the floor that are drawn
    std::vector<VehicleId> trails;
    std::size_t trailsDrawn = 0;
  };

  [[nodiscard]] bool wantsJob() const;
  void begin(const Ground& ground);
  [[nodiscard]] bool advance(const Ground& ground);
  void shift(QPoint by, const Ground& ground);
  static void drawTrails(Picture& picture, const QRect& strip, const Ground& ground);
  static void lengthenTrails(Picture& picture, const Ground& ground);

  std::optional<Picture> shown_;
  std::optional<Job> job_;
  View wanted_;  ///< with its margins
  View window_;
  int floorVersion_ = 0;
  int trailVersion_ = 0;
  int redraws_ = 0;
};

}  // namespace tessera::ui
