#include "ui/calibrate/calibrate_panel.h"

#include <QHeaderView>
#include <QLocale>

#include "ui/base/icon.h"
#include "ui/base/wording.h"
#include "ui/calibrate/panel_parts.h"

namespace tessera::ui {
namespace {

constexpr double kMmPerM = 1000.0;

}  // namespace

CalibratePanel::CalibratePanel(Calibration& work, FleetLink& fleet, Selection& selection, SiteDocument& document,
                               QWidget* parent)
    : CalibrationPanel{fleet, selection, document, parent}, work_{work} {
  setObjectName(QStringLiteral("calibratePanel"));
  build();
  begin(work_);
}

void CalibratePanel::build() {
  name_ = sentenceLabel(this, "calibratedVehicle");
  hint_ = sentenceLabel(this, "calibrateHint");
  progress_ = sentenceLabel(this, "calibrateProgress");
  figure_ = orderButton(this, "drawFigure", "route");
  record_ = orderButton(this, "recordCalibration", "run");
  reset_ = orderButton(this, "resetCalibration", "clear");
  accept_ = orderButton(this, "acceptCalibration", "check");
  wheels_ = new QCheckBox{this};
  wheels_->setObjectName(QStringLiteral("acceptWheels"));
  missing_ = sentenceLabel(this, "calibrateMissing");
  table_ = new QTableWidget{0, Columns, this};
  table_->setObjectName(QStringLiteral("calibrateTable"));
  table_->verticalHeader()->hide();
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->setFocusPolicy(Qt::NoFocus);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_->horizontalHeader()->setSectionResizeMode(What, QHeaderView::ResizeToContents);
  table_->setWordWrap(false);
  table_->setMinimumHeight(5 * fontMetrics().height());
  auto* orders = new QHBoxLayout;
  orders->addWidget(figure_);
  orders->addWidget(record_);
  orders->addWidget(reset_);
  auto* left = new QVBoxLayout;
  left->addWidget(name_);
  left->addLayout(orders);
  left->addWidget(hint_);
  left->addWidget(progress_);
  left->addStretch();
  auto* last = new QHBoxLayout;
  last->addWidget(wheels_);
  last->addWidget(missing_, 1);
  last->addWidget(accept_);
  auto* right = new QVBoxLayout;
  right->addWidget(table_, 1);
  right->addLayout(last);
  sides_->addLayout(left, 2);
  sides_->addLayout(right, 3);
  connect(figure_, &QPushButton::clicked, this, &CalibratePanel::drawFigure);
  connect(record_, &QPushButton::clicked, this, &CalibratePanel::record);
  connect(reset_, &QPushButton::clicked, &work_, &Calibration::clear);
  connect(accept_, &QPushButton::clicked, this, &CalibratePanel::accept);
}

QString CalibratePanel::name() const {
  return nameOf(document_, work_.isRecording() ? work_.vehicle() : selection_.vehicle());
}

void CalibratePanel::record() {
  if (work_.isRecording()) {
    work_.stop();
  } else if (selection_.vehicle()) {
    work_.start(*selection_.vehicle());
  }
}

void CalibratePanel::drawFigure() {
  const auto route = work_.drawFigure();
  if (!route) return void(Q_EMIT refused(text(route.error().sentence)));
  selection_.setRoute(*route);
}

void CalibratePanel::accept() {
  if (const auto done = work_.accept(wheels_->isChecked()); !done) Q_EMIT refused(text(done.error().sentence));
}

QString CalibratePanel::whatIsMissing() const {
  const auto* result = work_.result();
  if (result == nullptr || work_.setup() == nullptr) return {};
  const QLocale locale;
  switch (calibrate::lacking(work_.drive(), *result)) {
    case calibrate::Lacking::Turns:
      return tr("Not known well enough yet: let it make %1 half turns at least.").arg(calibrate::kFewestHalfTurns);
    case calibrate::Lacking::Drive:
      return tr("Not known well enough yet: drive on until the offsets' deviations are below ± %1 mm.")
          .arg(locale.toString(kMmPerM * calibrate::kWellKnown.value(), 'f', 1));
    case calibrate::Lacking::Nothing:
      break;
  }
  if (work_.areWheelsReady()) return {};
  return tr("Wheels not known well enough yet: drive on until their deviation is below ± %1 mm.")
      .arg(locale.toString(kMmPerM * work_.setup()->wheelDiameter.value() * calibrate::kWellKnownScale, 'f', 2));
}

QString CalibratePanel::whatNow() const {
  if (document_.site().vehicles.empty())
    return tr("The site has no vehicle yet. Set one up: Vehicle › Set up a new vehicle.");
  if (!fleet_.latest()) return tr("Connect to the vehicles: the calibration is a drive.");
  if (name().isEmpty()) return tr("Choose the vehicle to calibrate, in the list or on the floor.");
  if (!work_.isRecording() && work_.drive().motions().empty())
    return tr(
        "Draw the figure, or choose a route that crosses the rows of tags at a slant and turns often. Then press "
        "Record and run the vehicle along it, slowly (0.12 m/s).");
  if (work_.isRecording() && !work_.isReady())
    return tr("Run the vehicle along the route. Each tag that it reads tells a bit more.");
  if (work_.isRecording())
    return tr("Drive on until the deviations are small enough, then enter the values into the site.");
  return work_.isReady() ? tr("Compare the values. They are entered into the site as one step that can be undone.")
                         : tr("The drive was too short, or turned too little: press Record and go on.");
}

QString CalibratePanel::progress() const {
  const auto& drive = work_.drive();
  if (drive.motions().empty()) return {};
  const QLocale locale;
  QString line = tr("%1 m driven, %2 half turns, %3 reads.")
                     .arg(locale.toString(drive.length().value(), 'f', 1))
                     .arg(static_cast<int>(drive.turned().value() / kPi))
                     .arg(drive.reads().size());
  const auto* result = work_.result();
  if (result == nullptr) return line + QLatin1Char(' ') + text(work_.problem());
  if (result->outliers > 0)
    line += QLatin1Char(' ') + tr("%n read(s) fit nothing and hardly count.", nullptr, result->outliers);
  return line;
}

void CalibratePanel::refresh() {
  name_->setText(name());
  hint_->setText(whatNow());
  progress_->setText(progress());
  const bool ready = fleet_.latest() != nullptr && !name().isEmpty();
  record_->setEnabled(work_.isRecording() || ready);
  record_->setText(work_.isRecording() ? tr("Pause") : tr("Record"));
  record_->setIcon(icon(work_.isRecording() ? QStringLiteral("pause") : QStringLiteral("run")));
  reset_->setEnabled(!work_.drive().motions().empty());
  figure_->setEnabled(!document_.site().placements.empty());
  accept_->setEnabled(work_.isReady());
  wheels_->setEnabled(work_.areWheelsReady());
  missing_->setText(whatIsMissing());
  fillTable();
}

void CalibratePanel::setCell(int row, Column column, const QString& text) {
  auto* item = table_->item(row, column);
  if (item == nullptr) {
    item = new QTableWidgetItem;
    item->setTextAlignment((column == What ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    table_->setItem(row, column, item);
  }
  if (item->text() != text) item->setText(text);
}

void CalibratePanel::setRow(int row, const QString& what, double entered, double found, double deviation, int decimals,
                            bool told) {
  const QLocale locale;
  setCell(row, What, what);
  setCell(row, Entered, locale.toString(entered, 'f', decimals));
  setCell(row, Found, told ? locale.toString(found, 'f', decimals) : tr("not told"));
  setCell(row, Deviation, told ? QStringLiteral("± ") + locale.toString(deviation, 'f', decimals) : QString{});
}

void CalibratePanel::fillTable() {
  const floor::VehicleSetup* setup = work_.setup();
  const auto* result = work_.result();
  const bool some = setup != nullptr && result != nullptr && result->readers.size() == setup->readers.size();
  table_->setRowCount(some ? 2 * static_cast<int>(setup->readers.size()) + 1 : 0);
  if (!some) return;
  int row = 0;
  for (std::size_t r = 0; r < setup->readers.size(); ++r) {
    const auto& found = result->readers[r];
    const int number = static_cast<int>(r) + 1;
    setRow(row++, tr("Reader %1, ahead (mm)").arg(number), kMmPerM * setup->readers[r].x.value(),
           kMmPerM * found.mount.x.value(), kMmPerM * found.sigmaAhead.value(), 1, calibrate::isDetermined(found));
    setRow(row++, tr("Reader %1, to the left (mm)").arg(number), kMmPerM * setup->readers[r].y.value(),
           kMmPerM * found.mount.y.value(), kMmPerM * found.sigmaAside.value(), 1, calibrate::isDetermined(found));
  }
  const double diameter = kMmPerM * setup->wheelDiameter.value();
  setRow(row, tr("Diameter of the wheels (mm)"), diameter, diameter * result->wheelScale, diameter * result->wheelSigma,
         2, true);
}

void CalibratePanel::retranslate() {
  setWindowTitle(tr("Calibration"));
  figure_->setText(tr("Draw the figure"));
  figure_->setToolTip(tr("A route for this: a star that crosses the rows of tags at every slant. It can be undone"));
  reset_->setText(tr("Begin anew"));
  reset_->setToolTip(tr("Forget what was recorded so far"));
  accept_->setText(tr("Enter into the site"));
  accept_->setToolTip(tr("Readers that the drive tells of get the offsets found; it can be undone"));
  wheels_->setText(tr("the wheels as well"));
  wheels_->setToolTip(tr("The vehicle learns of its wheels by “Change the chosen vehicle”, page of the settings"));
  table_->setHorizontalHeaderLabels({tr("What"), tr("Entered"), tr("Found"), tr("Deviation (1 σ)")});
  table_->setAccessibleName(tr("What was found, beside what is entered"));
  refresh();
}

}  // namespace tessera::ui
