// F1 in whatever window of the program has the focus, dialogues included: a menu's shortcut is the main window's alone.
#pragma once

#include <QObject>

namespace tessera::ui {

class HelpKey : public QObject {
  Q_OBJECT
public:
  static constexpr Qt::Key kKey = Qt::Key_F1;

  explicit HelpKey(QObject* parent = nullptr);
  [[nodiscard]] bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
  void pressed();
};

}  // namespace tessera::ui
