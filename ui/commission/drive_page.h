// The first drive along a route, slowly, with Run and Stop at hand.
#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "ui/commission/step_page.h"

namespace tessera::ui {

class DrivePage : public StepPage {
  Q_OBJECT
public:
  explicit DrivePage(Commissioning& work, QWidget* parent = nullptr);
  void initializePage() override;

protected:
  void retranslate() override;
  void refresh(const supervisor::VehicleView* vehicle) override;
  void hideEvent(QHideEvent* event) override;

private:
  void run();
  void stop();
  [[nodiscard]] bool driving(const supervisor::VehicleView& vehicle) const;

  bool mine_ = false;   ///< a drive was begun here and has not ended
  bool begun_ = false;  ///< it has shown in a snapshot
  QLabel routeLabel_;
  QComboBox route_;
  QLabel speedLabel_;
  QDoubleSpinBox speed_;
  QPushButton run_;
  QPushButton stop_;
  QProgressBar progress_;
  QLabel doing_;
  Notice result_;
};

}  // namespace tessera::ui
