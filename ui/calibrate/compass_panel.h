// The compass calibrated by turning on the spot: what to do, the chart of the field all around, how good what was found
// is, and the buttons that write it into the vehicle or bring back what stood there before.
#pragma once

#include <QBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "ui/base/selection.h"
#include "ui/base/site_document.h"
#include "ui/base/throttle.h"
#include "ui/calibrate/compass_survey.h"
#include "ui/calibrate/field_chart.h"

namespace tessera::ui {

class CompassPanel : public QWidget {
  Q_OBJECT
public:
  /// All must outlive it.
  CompassPanel(CompassSurvey& work, FleetLink& fleet, Selection& selection, SiteDocument& document,
               QWidget* parent = nullptr);

protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  /// Nothing turns on behind a panel that is no longer looked at.
  void hideEvent(QHideEvent* event) override;

private:
  void build();
  void retranslate();
  void refresh();
  void startOrStop();
  [[nodiscard]] QString name() const;
  [[nodiscard]] QString whatNow() const;
  [[nodiscard]] QString figures() const;
  [[nodiscard]] bool mayTurn() const;

  CompassSurvey& work_;
  FleetLink& fleet_;
  Selection& selection_;
  SiteDocument& document_;
  QBoxLayout* sides_ = nullptr;
  QLabel* name_ = nullptr;
  QLabel* hint_ = nullptr;
  QLabel* figures_ = nullptr;
  QPushButton* turn_ = nullptr;
  QPushButton* write_ = nullptr;
  QPushButton* restore_ = nullptr;
  Notice* result_ = nullptr;
  FieldChart* chart_ = nullptr;
  Throttle throttle_;
};

}  // namespace tessera::ui
