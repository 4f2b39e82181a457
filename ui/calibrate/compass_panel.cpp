#include "ui/calibrate/compass_panel.h"

#include <QHideEvent>
#include <QLocale>
#include <cmath>

#include "ui/base/icon.h"
#include "ui/calibrate/panel_parts.h"

namespace tessera::ui {

CompassPanel::CompassPanel(CompassSurvey& work, FleetLink& fleet, Selection& selection, SiteDocument& document,
                           QWidget* parent)
    : CalibrationPanel{fleet, selection, document, parent}, work_{work} {
  setObjectName(QStringLiteral("compassPanel"));
  build();
  begin(work_);
}

void CompassPanel::build() {
  name_ = sentenceLabel(this, "surveyedVehicle");
  hint_ = sentenceLabel(this, "surveyHint");
  figures_ = sentenceLabel(this, "surveyFigures");
  turn_ = orderButton(this, "turnForSurvey", "compass");
  write_ = orderButton(this, "writeSurvey", "check");
  restore_ = orderButton(this, "restoreCompass", "revert");
  result_ = new Notice{this};
  result_->setObjectName(QStringLiteral("surveyResult"));
  chart_ = new FieldChart{this};
  auto* orders = new QHBoxLayout;
  orders->addWidget(turn_);
  orders->addWidget(write_);
  orders->addWidget(restore_);
  orders->addStretch();
  auto* left = new QVBoxLayout;
  left->addWidget(name_);
  left->addLayout(orders);
  left->addWidget(hint_);
  left->addWidget(result_);
  left->addWidget(figures_);
  left->addStretch();
  sides_->addLayout(left, 1);
  sides_->addWidget(chart_, 1);
  connect(turn_, &QPushButton::clicked, this, &CompassPanel::startOrStop);
  connect(write_, &QPushButton::clicked, &work_, &CompassSurvey::write);
  connect(restore_, &QPushButton::clicked, &work_, &CompassSurvey::restore);
}

void CompassPanel::hideEvent(QHideEvent* event) {
  if (work_.turns()) work_.stop();
  QWidget::hideEvent(event);
}

QString CompassPanel::name() const {
  return nameOf(document_, work_.isBusy() ? work_.vehicle() : selection_.vehicle());
}

bool CompassPanel::mayTurn() const {
  const auto snapshot = fleet_.latest();
  const auto* seen = snapshot && selection_.vehicle() ? snapshot->find(*selection_.vehicle()) : nullptr;
  return seen != nullptr && seen->contact == supervisor::Contact::Connected;
}

void CompassPanel::startOrStop() {
  if (work_.isBusy())
    work_.stop();
  else if (selection_.vehicle())
    work_.start(*selection_.vehicle());
}

QString CompassPanel::whatNow() const {
  if (document_.site().vehicles.empty())
    return tr("The site has no vehicle yet. Set one up: Vehicle › Set up a new vehicle.");
  if (!fleet_.latest()) return tr("Connect to the vehicles: the compass is calibrated by turning.");
  if (name().isEmpty()) return tr("Choose the vehicle to calibrate, in the list or on the floor.");
  if (!work_.isBusy() && !mayTurn()) return tr("The vehicle does not answer. Is it switched on and in reach?");
  return tr(
      "The vehicle turns on the spot by itself, a little more than once around and back. Put it on the floor, away "
      "from steel and cables, with a metre of free room all around; keep hands and feet away.");
}

QString CompassPanel::figures() const {
  const QLocale locale;
  if (work_.phase() == CompassSurvey::Phase::Turning || work_.phase() == CompassSurvey::Phase::Fetching)
    return tr("%1 of %2 directions measured.").arg(work_.points().size()).arg(wire::kCompassSamples);
  const auto& fit = work_.fit();
  if (!fit) return {};
  const auto number = [&](double value) { return locale.toString(value, 'f', 1); };
  constexpr auto kSectors = static_cast<int>(calibrate::CompassFit::kSectors);
  return tr("Hard iron %1 µT, soft iron %2 : 1, earth's field %3 µT. Points off the ellipse by %4 % (about %5° of "
            "heading); %6 of %7 directions met.")
      .arg(number(std::hypot(fit->ellipse.centre.x, fit->ellipse.centre.y)),
           locale.toString(fit->ellipse.longAxis / fit->ellipse.shortAxis, 'f', 2), number(fit->radius),
           number(100.0 * fit->misfit), number(degrees(Radians{fit->misfit})))
      .arg(kSectors - fit->missing())
      .arg(kSectors);
}

void CompassPanel::refresh() {
  name_->setText(name());
  hint_->setText(whatNow());
  figures_->setText(figures());
  figures_->setVisible(!figures_->text().isEmpty());
  if (work_.message().isEmpty())
    result_->clear();
  else
    result_->show(work_.tone(), work_.message());
  // A chart of one vehicle beside the name of another would mislead.
  const bool same = work_.isBusy() || selection_.vehicle() == work_.vehicle();
  result_->setVisible(same && !result_->text().isEmpty());
  figures_->setVisible(same && figures_->isVisibleTo(this));
  chart_->show(same ? work_.points() : std::vector<calibrate::FieldPoint>{},
               same ? work_.fit() : std::optional<calibrate::CompassFit>{});
  turn_->setText(work_.measures() ? tr("Stop") : tr("Turn and measure"));
  turn_->setIcon(icon(work_.measures() ? QStringLiteral("stop") : QStringLiteral("compass")));
  turn_->setEnabled(work_.measures() || (!work_.isBusy() && !name().isEmpty() && mayTurn()));
  write_->setEnabled(same && work_.mayWrite());
  restore_->setEnabled(same && work_.mayRestore());
}

void CompassPanel::retranslate() {
  setWindowTitle(tr("Compass"));
  write_->setText(tr("Write into the vehicle"));
  restore_->setText(tr("Old values back"));
  restore_->setToolTip(tr("What stood in the vehicle before something was written into it here"));
  refresh();
}

}  // namespace tessera::ui
