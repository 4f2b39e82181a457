#include "ui/commission/jog_page.h"

#include <QLocale>

namespace tessera::ui {

JogPage::JogPage(Commissioning& work, QWidget* parent)
    : StepPage{work, Commissioning::Step::Jog, Needs::Vehicle, parent}, pad_{work.link(), work.selection()} {
  hint_.setWordWrap(true);
  speed_.setAlignment(Qt::AlignCenter);
  content().addWidget(&hint_);
  content().addWidget(&pad_, 1);
  content().addWidget(&speed_);
}

// Done when it has moved, not when a key was pressed.
void JogPage::refresh(const supervisor::VehicleView* vehicle) {
  if (vehicle == nullptr) {
    speed_.clear();
    return;
  }
  speed_.setText(tr("Measured by its wheels: %1 m/s").arg(QLocale{}.toString(vehicle->speed.value(), 'f', 3)));
  if (vehicle->task == supervisor::Task::Jogging && abs(vehicle->speed).value() > 0.005) markDone();
}

void JogPage::retranslate() {
  setTitle(tr("Drive by hand"));
  setSubTitle(tr("Put the vehicle on the floor with free room around it, and move it a little each way."));
  hint_.setText(
      tr("If it goes backwards when it should go forwards, a motor is connected the wrong way round; if it "
         "turns the wrong way, the motors are swapped."));
  StepPage::retranslate();
}

}  // namespace tessera::ui
