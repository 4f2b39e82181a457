// Driving by hand. The vehicle moves only while an arrow is held, by key or by mouse; letting go, or losing the
// keyboard, the window or the vehicle, stops it at once.
#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QSlider>
#include <QTimer>
#include <QToolButton>
#include <QWidget>
#include <array>
#include <optional>

#include "ui/base/fleet_link.h"
#include "ui/base/selection.h"

namespace tessera::ui {

class JogPad : public QWidget {
  Q_OBJECT
public:
  /// Drives the selected vehicle.
  JogPad(FleetLink& link, Selection& selection, QWidget* parent = nullptr);
  ~JogPad() override;

  [[nodiscard]] MetresPerSecond speed() const;
  /// An arrow is held and orders go out.
  [[nodiscard]] bool isHeld() const { return held_ != 0; }

Q_SIGNALS:
  /// An arrow was pressed and the vehicle is being driven.
  void driven();

protected:
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  bool event(QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  enum Arrow : unsigned { kForward = 1, kBackward = 2, kLeft = 4, kRight = 8 };
  static constexpr std::array<Arrow, 4> kArrows{kForward, kBackward, kLeft, kRight};

  void layOut();
  void retranslate();
  void showState();
  void press(Arrow arrow);
  void release(Arrow arrow);
  void letGo();
  void send();
  /// Why no vehicle can be driven now; empty: one can.
  [[nodiscard]] QString obstacle() const;
  [[nodiscard]] static std::optional<Arrow> arrowOf(int key);
  QToolButton& buttonOf(Arrow arrow);

  FleetLink& link_;
  Selection& selection_;
  unsigned held_ = 0;
  std::optional<VehicleId> moving_;  ///< the one that was sent a Jog and no Stop since
  bool refused_ = false;
  QTimer repeat_;
  QElapsedTimer stopped_;  ///< since the last Stop

  std::array<QToolButton, 4> buttons_;
  QLabel speedLabel_;
  QSlider slider_;
  QLabel hint_;
};

}  // namespace tessera::ui
