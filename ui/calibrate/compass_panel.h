// The compass calibrated by turning on the spot: what to do, the chart of the field all around, how good what was found
// is, and the buttons that write it into the vehicle or bring back what stood there before.
#pragma once

#include <QLabel>
#include <QPushButton>

#include "ui/calibrate/calibration_panel.h"
#include "ui/calibrate/compass_survey.h"
#include "ui/calibrate/field_chart.h"

namespace tessera::ui {

class CompassPanel : public CalibrationPanel {
  Q_OBJECT
public:
  /// All must outlive it.
  CompassPanel(CompassSurvey& work, FleetLink& fleet, Selection& selection, SiteDocument& document,
               QWidget* parent = nullptr);

protected:
  /// Nothing turns on behind a panel that is no longer looked at.
  void hideEvent(QHideEvent* event) override;

private:
  void build();
  void retranslate() override;
  void refresh() override;
  void startOrStop();
  [[nodiscard]] QString name() const;
  [[nodiscard]] QString whatNow() const;
  [[nodiscard]] QString figures() const;
  [[nodiscard]] bool mayTurn() const;

  CompassSurvey& work_;
  QLabel* figures_ = nullptr;
  QPushButton* turn_ = nullptr;
  QPushButton* write_ = nullptr;
  QPushButton* restore_ = nullptr;
  Notice* result_ = nullptr;
  FieldChart* chart_ = nullptr;
};

}  // namespace tessera::ui
