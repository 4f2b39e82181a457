// Is the vehicle there, and is it the right one? Live from the air: firmware, link, and otherwise what is wrong.
#pragma once

#include <QFormLayout>
#include <QLabel>
#include <array>

#include "ui/commission/step_page.h"

namespace tessera::ui {

class ContactPage : public StepPage {
  Q_OBJECT
public:
  explicit ContactPage(Commissioning& work, QWidget* parent = nullptr);

protected:
  void retranslate() override;
  void refresh(const supervisor::VehicleView* vehicle) override;

private:
  enum Row { kFirmware, kReaders, kBattery, kLastHeard, kRoundTrip, kLoss, kFaults, kRows };
  struct Line {
    QLabel name;
    QLabel value;
  };
  std::array<Line, kRows> lines_;
  Notice result_;
};

}  // namespace tessera::ui
