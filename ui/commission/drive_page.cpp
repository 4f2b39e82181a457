#include "ui/commission/drive_page.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLocale>
#include <algorithm>

#include "ui/base/wording.h"

namespace tessera::ui {

DrivePage::DrivePage(Commissioning& work, QWidget* parent)
    : StepPage{work, Commissioning::Step::Drive, Needs::Vehicle, parent} {
  route_.setObjectName(QStringLiteral("firstRoute"));
  speed_.setObjectName(QStringLiteral("firstSpeed"));
  run_.setObjectName(QStringLiteral("firstRun"));
  stop_.setObjectName(QStringLiteral("firstStop"));
  result_.setObjectName(QStringLiteral("firstResult"));
  progress_.setObjectName(QStringLiteral("firstProgress"));
  speed_.setRange(0.02, 0.20);
  speed_.setSingleStep(0.01);
  speed_.setDecimals(2);
  speed_.setValue(0.05);
  progress_.setRange(0, 1000);
  doing_.setWordWrap(true);
  doing_.setMinimumHeight(fontMetrics().lineSpacing() * 2);
  doing_.setAlignment(Qt::AlignTop | Qt::AlignLeft);
  routeLabel_.setBuddy(&route_);
  speedLabel_.setBuddy(&speed_);
  auto* grid = new QGridLayout;
  grid->addWidget(&routeLabel_, 0, 0);
  grid->addWidget(&route_, 0, 1);
  grid->addWidget(&speedLabel_, 1, 0);
  grid->addWidget(&speed_, 1, 1, Qt::AlignLeft);
  grid->setColumnStretch(1, 1);
  auto* buttons = new QHBoxLayout;
  for (QPushButton* button : {&run_, &stop_}) {
    button->setAutoDefault(false);
    buttons->addWidget(button);
  }
  buttons->addStretch();
  content().addLayout(grid);
  content().addLayout(buttons);
  content().addWidget(&progress_);
  content().addWidget(&doing_);
  content().addWidget(&result_);
  content().addStretch();
  connect(&run_, &QPushButton::clicked, this, &DrivePage::run);
  connect(&stop_, &QPushButton::clicked, this, &DrivePage::stop);
}

void DrivePage::initializePage() {
  const QString chosen = route_.currentText();
  route_.clear();
  for (const floor::Route& r : work().document().site().routes) route_.addItem(QString::fromStdString(r.name));
  if (const int index = route_.findText(chosen); index >= 0) route_.setCurrentIndex(index);
  mine_ = begun_ = false;
  progress_.setValue(0);
  doing_.clear();
  result_.clear();
  StepPage::initializePage();
}

void DrivePage::run() {
  result_.clear();
  begun_ = false;
  mine_ = work().link().post(
      supervisor::RunRoute{work().address(), route_.currentText().toStdString(), MetresPerSecond{speed_.value()}});
  if (!mine_) result_.show(Notice::Tone::Error, tr("The order was not taken: no supervision runs. Connect anew."));
}

void DrivePage::stop() {
  work().link().post(supervisor::Stop{work().address()});
  mine_ = false;
}

// Behind a page that is not looked at nothing drives on.
void DrivePage::hideEvent(QHideEvent* event) {
  if (mine_) stop();
  StepPage::hideEvent(event);
}

bool DrivePage::driving(const supervisor::VehicleView& v) const {
  return v.task == supervisor::Task::Running || v.task == supervisor::Task::Paused;
}

void DrivePage::refresh(const supervisor::VehicleView* v) {
  const bool any = route_.count() > 0;
  run_.setEnabled(v != nullptr && any && !driving(*v));
  stop_.setEnabled(v != nullptr);
  if (!any)
    result_.show(Notice::Tone::Info, tr("The site has no route yet. Draw one on the floor, and make the first "
                                        "drive from the main window."));
  if (v == nullptr) return;
  const double length = v->length.value();
  progress_.setValue(length > 0 ? static_cast<int>(1000 * std::clamp(v->progress.value() / length, 0.0, 1.0)) : 0);
  if (!v->located)
    doing_.setText(tr("Its place is not known yet. Drive it by hand over a few tags of the floor (one step back)."));
  else
    doing_.setText(v->waits.empty() ? text(v->doing) : text(v->waits));
  begun_ = begun_ || driving(*v);
  if (mine_ && begun_ && (v->finished || v->task == supervisor::Task::Finished)) {
    mine_ = false;
    result_.show(Notice::Tone::Good, tr("The route's end was reached. The vehicle is ready."));
    markDone();
  } else if (mine_ && begun_ && !driving(*v)) {
    mine_ = false;
    result_.show(Notice::Tone::Info, tr("Stopped before the route's end. Run it again, or skip this step."));
  }
}

void DrivePage::retranslate() {
  setTitle(tr("First drive"));
  setSubTitle(tr("A short route, slowly. Stay near the vehicle, with a hand on its emergency stop."));
  routeLabel_.setText(tr("R&oute:"));
  route_.setPlaceholderText(tr("no routes"));
  speedLabel_.setText(tr("Sp&eed:"));
  speed_.setSuffix(tr(" m/s"));
  run_.setText(tr("&Run"));
  stop_.setText(tr("&Stop"));
  progress_.setAccessibleName(tr("Progress along the route"));
  StepPage::retranslate();
}

}  // namespace tessera::ui
