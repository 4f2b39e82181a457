// Keeps a dialogue high enough for its wrapped sentences: a layout's own minimum does not count their lines.
#pragma once

#include <QEvent>
#include <QLayout>
#include <QWidget>

namespace tessera::ui {

class FitHeight : public QObject {
  Q_OBJECT
public:
  /// Lives as long as the dialogue.
  explicit FitHeight(QWidget& dialog) : QObject{&dialog}, dialog_{dialog} { dialog_.installEventFilter(this); }

  bool eventFilter(QObject* watched, QEvent* event) override {
    const bool may =
        event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize || event->type() == QEvent::Show;
    if (may && watched == &dialog_ && dialog_.layout() != nullptr) {
      const int needed = dialog_.layout()->totalHeightForWidth(dialog_.width());
      if (needed > 0 && needed != dialog_.minimumHeight()) dialog_.setMinimumHeight(needed);
    }
    return QObject::eventFilter(watched, event);
  }

private:
  QWidget& dialog_;
};

}  // namespace tessera::ui
