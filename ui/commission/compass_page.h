// Does the compass tell where the nose points? Live bearing, and the calibration in which the vehicle turns on the
// spot: with its chart, or by the vehicle alone where its program is too old to tell what it measures.
#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QPushButton>

#include "ui/base/ask_series.h"
#include "ui/calibrate/compass_panel.h"
#include "ui/calibrate/compass_survey.h"
#include "ui/commission/heading_dial.h"
#include "ui/commission/step_page.h"

namespace tessera::ui {

class CompassPage : public StepPage {
  Q_OBJECT
public:
  explicit CompassPage(Commissioning& work, QWidget* parent = nullptr);
  void initializePage() override;
  [[nodiscard]] QString holdsOpen() const override;

protected:
  void retranslate() override;
  void refresh(const supervisor::VehicleView* vehicle) override;
  void hideEvent(QHideEvent* event) override;

private:
  enum class Phase { Idle, Asking, Turning, Reading };

  void calibrate();
  void stop();
  void hear(const supervisor::AskAnswer& answer);
  void end(Notice::Tone tone, const QString& sentence);
  void judgeSurvey();
  void showButtons();

  AskSeries series_;
  Phase phase_ = Phase::Idle;
  bool turned_ = false;
  bool reachable_ = false;
  QElapsedTimer sinceStart_;
  HeadingDial dial_;
  QLabel bearing_;
  QLabel hint_;
  QPushButton right_;
  QPushButton calibrate_;
  QPushButton stop_;
  Notice result_;
  CompassSurvey survey_;
  CompassPanel panel_;
};

}  // namespace tessera::ui
