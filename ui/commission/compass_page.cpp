#include "ui/commission/compass_page.h"

#include <QHBoxLayout>
#include <QLocale>
#include <cmath>

#include "base/angle.h"
#include "floor/bearing.h"
#include "wire/parameters.h"

namespace tessera::ui {
namespace {

// A calibration that was started shows in the reports by then, or is over already.
constexpr qint64 kCalibrationShowsMs = 3000;

}  // namespace

CompassPage::CompassPage(Commissioning& work, QWidget* parent)
    : StepPage{work, Commissioning::Step::Compass, Needs::Vehicle, parent},
      series_{work.link()},
      survey_{work.link()},
      panel_{survey_, work.link(), work.selection(), work.document()} {
  right_.setObjectName(QStringLiteral("compassRight"));
  calibrate_.setObjectName(QStringLiteral("calibrateCompass"));
  stop_.setObjectName(QStringLiteral("stopCalibration"));
  result_.setObjectName(QStringLiteral("compassResult"));
  bearing_.setObjectName(QStringLiteral("bearing"));
  QFont large = font();
  large.setPointSizeF(large.pointSizeF() * 1.5);
  bearing_.setFont(large);
  bearing_.setAlignment(Qt::AlignCenter);
  hint_.setWordWrap(true);
  auto* left = new QVBoxLayout;
  left->addWidget(&dial_);
  left->addWidget(&bearing_);
  auto* right = new QVBoxLayout;
  right->addWidget(&hint_);
  for (QPushButton* button : {&right_, &calibrate_, &stop_}) {
    button->setAutoDefault(false);
    right->addWidget(button, 0, Qt::AlignLeft);
  }
  right->addWidget(&result_);
  right->addStretch();
  auto* row = new QHBoxLayout;
  row->addLayout(left);
  row->addSpacing(fontMetrics().height());
  row->addLayout(right, 1);
  content().addLayout(row);
  content().addWidget(&panel_, 1);

  connect(&right_, &QPushButton::clicked, this, [this] { markDone(); });
  connect(&calibrate_, &QPushButton::clicked, this, &CompassPage::calibrate);
  connect(&stop_, &QPushButton::clicked, this, [this] {
    stop();
    end(Notice::Tone::Info, tr("Calibration stopped; the vehicle keeps its old calibration."));
  });
  connect(&series_, &AskSeries::answered, this,
          [this](std::size_t, const supervisor::AskAnswer& answer) { hear(answer); });
  connect(&series_, &AskSeries::failed, this, [this](const QString& sentence) { end(Notice::Tone::Error, sentence); });
  connect(&survey_, &CompassSurvey::changed, this, &CompassPage::judgeSurvey);
}

void CompassPage::initializePage() {
  phase_ = Phase::Idle;
  result_.clear();
  StepPage::initializePage();
  showButtons();
}

// Nothing turns on behind a page that is no longer looked at.
void CompassPage::hideEvent(QHideEvent* event) {
  if (phase_ == Phase::Asking || phase_ == Phase::Turning) stop();
  StepPage::hideEvent(event);
}

void CompassPage::calibrate() {
  phase_ = Phase::Asking;
  turned_ = false;
  sinceStart_.start();
  result_.show(Notice::Tone::Info, tr("The vehicle turns on the spot…"));
  series_.start(work().address(), {{wire::MessageType::Do, static_cast<std::uint8_t>(wire::Action::CalibrateCompass)}});
  showButtons();
}

void CompassPage::stop() {
  series_.stop();
  work().link().post(supervisor::Stop{work().address()});
  phase_ = Phase::Idle;
}

void CompassPage::end(Notice::Tone tone, const QString& sentence) {
  phase_ = Phase::Idle;
  result_.show(tone, sentence);
  showButtons();
}

void CompassPage::hear(const supervisor::AskAnswer& answer) {
  if (phase_ == Phase::Asking) {
    switch (answer.value->outcome) {
      case wire::Outcome::Started:
      case wire::Outcome::Done:
        phase_ = Phase::Turning;
        sinceStart_.restart();
        return;
      case wire::Outcome::Busy:
        return end(Notice::Tone::Error, tr("The vehicle drives or calibrates already. Stop it, then try again."));
      default:
        return end(Notice::Tone::Error, tr("The vehicle refuses, as it has a fault. Clear the fault, then try again."));
    }
  }
  if (phase_ != Phase::Reading) return;
  if (static_cast<wire::Outcome>(answer.value->value) == wire::Outcome::Done) {
    end(Notice::Tone::Good, tr("Calibrated. Now the needle must point to north when the nose does."));
    markDone();
  } else {
    end(Notice::Tone::Error, tr("The calibration failed: the field was not even enough. Move the vehicle away from "
                                "steel and cables and try again; it needs room for a full turn."));
  }
}

// Right as it stands in the vehicle, or written into it and read back; no longer so when something else was written.
void CompassPage::judgeSurvey() {
  if (!survey_.isBusy() && survey_.isRight()) markDone(*survey_.isRight());
  showButtons();
}

QString CompassPage::holdsOpen() const {
  if (!survey_.writes()) return {};
  return tr(
      "The values of the compass are being written into the vehicle. Closed now, it would keep half old and half "
      "new ones: wait a few seconds, then close.");
}

void CompassPage::refresh(const supervisor::VehicleView* vehicle) {
  reachable_ = vehicle != nullptr;
  if (vehicle == nullptr) {
    dial_.setBearing(std::nullopt);
    bearing_.setText(tr("–", "no value"));
  } else {
    const Radians bearing = floor::bearingOfHeading(vehicle->heading, work().document().site().northToY);
    dial_.setBearing(bearing);
    const int degrees = (static_cast<int>(std::lround(bearing.value() * 180 / kPi)) + 360) % 360;
    bearing_.setText(tr("%1°").arg(QLocale{}.toString(degrees)));
    const bool turning = vehicle->state == wire::VehicleState::Calibrating;
    turned_ = turned_ || turning;
    if (phase_ == Phase::Turning && !turning && (turned_ || sinceStart_.elapsed() > kCalibrationShowsMs)) {
      phase_ = Phase::Reading;
      series_.start(work().address(),
                    {{wire::MessageType::Get, static_cast<std::uint8_t>(wire::Parameter::CalibrationOutcome)}});
    }
  }
  showButtons();
}

void CompassPage::showButtons() {
  const bool idle = phase_ == Phase::Idle && !survey_.isBusy();
  calibrate_.setVisible(survey_.isTooOld());
  calibrate_.setEnabled(reachable_ && idle);
  panel_.setEnabled(phase_ == Phase::Idle);
  right_.setEnabled(reachable_ && idle && work().mark(Commissioning::Step::Compass) != Commissioning::Mark::Done);
  stop_.setVisible(phase_ == Phase::Asking || phase_ == Phase::Turning);
}

void CompassPage::retranslate() {
  setTitle(tr("The compass"));
  setSubTitle(tr("Turn the vehicle by hand until its nose points to north: the needle must follow."));
  hint_.setText(
      tr("If the needle is off by more than about 10°, calibrate: have the vehicle turn and measure, then write what "
         "was found into it."));
  right_.setText(tr("The needle is &right"));
  calibrate_.setText(tr("Ca&librate without a chart"));
  stop_.setText(tr("&Stop"));
  StepPage::retranslate();
}

}  // namespace tessera::ui
