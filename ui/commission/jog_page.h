// The first move: by hand, with the arrows.
#pragma once

#include <QLabel>

#include "ui/commission/jog_pad.h"
#include "ui/commission/step_page.h"

namespace tessera::ui {

class JogPage : public StepPage {
  Q_OBJECT
public:
  explicit JogPage(Commissioning& work, QWidget* parent = nullptr);

protected:
  void retranslate() override;
  void refresh(const supervisor::VehicleView* vehicle) override;

private:
  QLabel hint_;
  JogPad pad_;
  QLabel speed_;
};

}  // namespace tessera::ui
