// Driving the chosen vehicle by hand, in a window of its own beside the floor.
#pragma once

#include <QDialog>
#include <QLabel>

#include "ui/commission/jog_pad.h"

namespace tessera::ui {

class JogDialog : public QDialog {
  Q_OBJECT
public:
  /// Drives the selected vehicle, whichever that is at the time.
  JogDialog(FleetLink& link, Selection& selection, QWidget* parent = nullptr);

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslate();
  void nameVehicle();

  FleetLink& link_;
  Selection& selection_;
  QLabel vehicle_;
  JogPad pad_;
};

}  // namespace tessera::ui
