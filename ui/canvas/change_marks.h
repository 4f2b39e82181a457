// What differs between the floor and another state of it, drawn upon it: what came, what went, what is elsewhere, what
// is another. Told apart by shape and line as well as by colour.
#pragma once

#include <QPainter>
#include <QString>
#include <optional>
#include <vector>

#include "ui/canvas/layer_picture.h"
#include "ui/canvas/theme.h"
#include "ui/canvas/view.h"

namespace tessera::ui {

enum class ChangeLook : std::uint8_t { Added, Removed, Moved, Changed };

struct ChangeMarks {
  /// Areas (closed, with holes) or one open line.
  struct Shape {
    ChangeLook look = ChangeLook::Changed;
    std::vector<std::vector<Point>> lines;
    bool closed = true;
  };
  struct Sign {
    ChangeLook look = ChangeLook::Changed;
    SiteBox place;              ///< empty: nowhere in particular, so that nothing is drawn
    std::optional<Point> from;  ///< of what was moved: where its middle was
    QString sentence;           ///< under the mouse
  };
  QString title;  ///< of the legend
  std::vector<Shape> shapes;
  std::vector<Sign> signs;
  std::optional<std::size_t> chosen;  ///< the sign that is looked at
  [[nodiscard]] bool empty() const { return shapes.empty() && signs.empty(); }
};

void paintChanges(QPainter& painter, const View& view, const CanvasTheme& theme, const ChangeMarks& changes);

class ChangeLayer {
public:
  void set(ChangeMarks marks);
  [[nodiscard]] const ChangeMarks& marks() const { return marks_; }
  void paint(QPainter& painter, const View& view, const CanvasTheme& theme);

private:
  ChangeMarks marks_;
  LayerPicture picture_;
};

/// Names the looks that occur, in the window's upper left corner. Gives how far down it reaches.
double paintChangeLegend(QPainter& painter, const View& view, const CanvasTheme& theme, const ChangeMarks& changes);
/// The sign alone, as in the legend and in lists.
void paintChangeSign(QPainter& painter, const CanvasTheme& theme, ChangeLook look, QPointF at, double reach);
/// "Added".
[[nodiscard]] QString changeLookText(ChangeLook look);
/// Whose sign lies under the pixel; nullptr: none.
[[nodiscard]] const ChangeMarks::Sign* changeAt(const ChangeMarks& changes, const View& view, QPointF pixel);

}  // namespace tessera::ui
