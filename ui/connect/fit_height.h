// Keeps a dialogue high enough for its wrapped sentences: a layout's own minimum does not count their lines.
#pragma once

#include <QEvent>
#include <QLayout>
#include <QWidget>
#include <algorithm>

namespace tessera::ui {

class FitHeight : public QObject {
  Q_OBJECT
public:
  /// Lives as long as the dialogue, which is at least so wide.
  FitHeight(QWidget& dialog, int width) : QObject{&dialog}, dialog_{dialog}, width_{width} {
    dialog_.installEventFilter(this);
  }

  bool eventFilter(QObject* watched, QEvent* event) override {
    const bool may =
        event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize || event->type() == QEvent::Show;
    if (may && watched == &dialog_ && dialog_.layout() != nullptr) {
      const int width = std::max(width_, dialog_.layout()->totalMinimumSize().width());
      const int height = dialog_.layout()->totalHeightForWidth(std::max(width, dialog_.width()));
      if (height > 0 && QSize{width, height} != dialog_.minimumSize()) dialog_.setMinimumSize(width, height);
    }
    return QObject::eventFilter(watched, event);
  }

private:
  QWidget& dialog_;
  int width_;
};

}  // namespace tessera::ui
