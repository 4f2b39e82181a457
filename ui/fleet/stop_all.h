// Stop all: the big red button, and the key that does the same from any window or dialogue of the program.
#pragma once

#include <QAbstractButton>

#include "ui/base/fleet_link.h"

namespace tessera::ui {

/// Acts when pressed, not when let go: the hand that hits it may slip.
class StopAllButton : public QAbstractButton {
  Q_OBJECT
public:
  explicit StopAllButton(FleetLink& link, QWidget* parent = nullptr);

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

Q_SIGNALS:
  /// False: there is no supervision that could have taken it, so no vehicle is driven by this program.
  void ordered(bool taken);

protected:
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  void retranslate();
  [[nodiscard]] QFont labelFont() const;

  FleetLink& link_;
};

/// F12, whatever modifiers are held with it, wherever the focus is. Lives as long as the main window.
class StopAllKey : public QObject {
  Q_OBJECT
public:
  static constexpr Qt::Key kKey = Qt::Key_F12;

  explicit StopAllKey(FleetLink& link, QObject* parent = nullptr);
  [[nodiscard]] bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
  void ordered(bool taken);

private:
  FleetLink& link_;
};

}  // namespace tessera::ui
