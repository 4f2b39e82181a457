// How the firmware gets onto the vehicle's board, with commands to copy; and how to try all this without a vehicle.
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <array>

#include "ui/commission/step_page.h"

namespace tessera::ui {

class FlashPage : public StepPage {
  Q_OBJECT
public:
  explicit FlashPage(Commissioning& work, QWidget* parent = nullptr);

protected:
  void retranslate() override;

private:
  struct Command {
    QLabel what;
    QLineEdit line;
    QPushButton copy;
  };
  QLabel intro_;
  std::array<Command, 3> commands_;
  QLabel demo_;
  QPushButton done_;
};

}  // namespace tessera::ui
