// How the run panel is laid out, and how it shows texts and colours.
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/base/icon.h"
#include "ui/base/vehicle_colour.h"
#include "ui/fleet/run_panel.h"

namespace tessera::ui {
namespace {

QLabel* wrappingLabel(const QString& name, QWidget* parent) {
  auto* label = new QLabel{parent};
  label->setObjectName(name);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

QFont larger(QFont font, double factor) {
  font.setPointSizeF(font.pointSizeF() * factor);
  font.setBold(true);
  return font;
}

QToolButton* actionButton(QAction* action, const QString& name, QWidget* parent) {
  auto* button = new QToolButton{parent};
  button->setObjectName(name);
  button->setDefaultAction(action);
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setFocusPolicy(Qt::StrongFocus);
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  const int side = button->fontMetrics().height() * 5 / 4;
  button->setIconSize({side, side});
  return button;
}

}  // namespace

QAction* RunPanel::makeAction(const QString& name, const QKeySequence& key, void (RunPanel::*order)()) {
  auto* action = new QAction{this};
  action->setObjectName(name);
  action->setShortcut(key);
  action->setAutoRepeat(false);
  connect(action, &QAction::triggered, this, order);
  addAction(action);
  return action;
}

void RunPanel::build() {
  run_ = makeAction(QStringLiteral("runAction"), Qt::Key_F5, &RunPanel::run);
  pause_ = makeAction(QStringLiteral("pauseAction"), Qt::Key_F6, &RunPanel::pauseOrResume);
  stop_ = makeAction(QStringLiteral("stopAction"), Qt::Key_F7, &RunPanel::stop);
  clear_ = makeAction(QStringLiteral("clearAction"), {}, &RunPanel::clear);
  run_->setIcon(icon(QStringLiteral("run")));
  stop_->setIcon(icon(QStringLiteral("stop")));
  clear_->setIcon(icon(QStringLiteral("clear")));

  nobody_ = new FleetHint{QStringLiteral("vehicle"), this};
  nobody_->button()->setObjectName(QStringLiteral("runPanelCommission"));
  connect(nobody_->button(), &QPushButton::clicked, this, &RunPanel::commissionRequested);
  pages_ = new QStackedLayout{this};
  pages_->addWidget(buildVehicle());
  pages_->addWidget(nobody_);
}

QWidget* RunPanel::buildVehicle() {
  auto* page = new QWidget{this};
  dot_ = new QLabel{page};
  name_ = new QLabel{page};
  name_->setObjectName(QStringLiteral("vehicleName"));
  name_->setTextFormat(Qt::PlainText);
  stateIcon_ = new QLabel{page};
  state_ = new QLabel{page};
  state_->setObjectName(QStringLiteral("vehicleState"));
  auto* head = new QHBoxLayout;
  head->addWidget(dot_);
  head->addWidget(name_);
  head->addStretch();
  head->addWidget(stateIcon_);
  head->addWidget(state_);

  sentence_ = wrappingLabel(QStringLiteral("situation"), page);
  sentence_->setMinimumHeight(fontMetrics().lineSpacing() * 2);
  sentence_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  progress_ = new QProgressBar{page};
  progress_->setObjectName(QStringLiteral("progress"));
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setFixedHeight(fontMetrics().height() / 2);
  remaining_ = wrappingLabel(QStringLiteral("remaining"), page);

  route_ = new QComboBox{page};
  route_->setObjectName(QStringLiteral("routeBox"));
  route_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  route_->setMinimumContentsLength(8);
  connect(route_, &QComboBox::currentTextChanged, this, [this](const QString& chosen) {
    if (!filling_) selection_.setRoute(chosen);
  });
  drawRoute_ = new QToolButton{page};
  drawRoute_->setObjectName(QStringLiteral("drawRouteButton"));
  drawRoute_->setIcon(icon(QStringLiteral("route")));
  drawRoute_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  connect(drawRoute_, &QToolButton::clicked, this, &RunPanel::drawRouteRequested);
  auto* routeRow = new QHBoxLayout;
  routeRow->addWidget(route_, 1);
  routeRow->addWidget(drawRoute_);
  speed_ = new QDoubleSpinBox{page};
  speed_->setObjectName(QStringLiteral("speedBox"));
  speed_->setDecimals(2);
  speed_->setSingleStep(0.05);
  connect(speed_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    if (filling_ || !selection_.vehicle()) return;
    speeds_[selection_.vehicle()->value] = value;
    refresh();
  });
  routeLabel_ = new QLabel{page};
  routeLabel_->setBuddy(route_);
  speedLabel_ = new QLabel{page};
  speedLabel_->setBuddy(speed_);
  auto* form = new QFormLayout;
  form->addRow(routeLabel_, routeRow);
  form->addRow(speedLabel_, speed_);

  auto* orders = new QHBoxLayout;
  orders->addWidget(actionButton(run_, QStringLiteral("runButton"), page));
  orders->addWidget(actionButton(pause_, QStringLiteral("pauseButton"), page));
  orders->addWidget(actionButton(stop_, QStringLiteral("stopButton"), page));
  notice_ = new Notice{page};
  notice_->setObjectName(QStringLiteral("runNotice"));

  auto* column = new QVBoxLayout{page};
  // What comes and goes, or grows with its text, lies below the buttons: they must not move away under the mouse.
  column->addLayout(head);
  column->addLayout(form);
  column->addLayout(orders);
  column->addWidget(actionButton(clear_, QStringLiteral("clearButton"), page));
  column->addWidget(sentence_);
  column->addWidget(progress_);
  column->addWidget(remaining_);
  column->addWidget(notice_);
  column->addStretch();
  return page;
}

void RunPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange) retranslate();
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
    holdPauseWidth();
    dress();
    refresh();
  }
  QWidget::changeEvent(event);
}

void RunPanel::retranslate() {
  if (document_.site().vehicles.empty()) {
    nobody_->setTexts(tr("This site has no vehicle yet. Set one up: the wizard leads through it."),
                      tr("Set up a vehicle…"));
  } else {
    nobody_->setTexts(tr("Choose a vehicle in the list or on the floor."));
  }
  routeLabel_->setText(tr("R&oute:"));
  route_->setPlaceholderText(route_->count() == 0 ? tr("No route yet") : tr("Choose a route"));
  drawRoute_->setText(tr("&Draw a route"));
  drawRoute_->setToolTip(tr("Draw a route on the floor."));
  speedLabel_->setText(tr("S&peed:"));
  speed_->setSuffix(tr(" m/s"));
  speed_->setLocale(QLocale{});
  speed_->setToolTip(
      tr("The fastest that it shall drive, from %1 to %2 m/s.")
          .arg(QLocale{}.toString(speed_->minimum(), 'f', 2), QLocale{}.toString(speed_->maximum(), 'f', 2)));
  progress_->setAccessibleName(tr("Progress on the route"));
  run_->setText(tr("&Run"));
  stop_->setText(tr("S&top"));
  clear_->setText(tr("&Clear faults"));
  holdPauseWidth();
  dress();
  refresh();
}

// Stop beside it must not move when the word changes.
void RunPanel::holdPauseWidth() {
  auto* button = findChild<QToolButton*>(QStringLiteral("pauseButton"));
  int most = 0;
  for (const QString& word : {tr("R&esume"), tr("&Pause")}) {
    pause_->setText(word);
    most = std::max(most, button->sizeHint().width());
  }
  button->setMinimumWidth(most);
}

// What the state decides is drawn when it comes to another state.
void RunPanel::dress() {
  shown_.reset();
  if (setup() == nullptr) return;
  const int side = fontMetrics().height() * 5 / 4;
  const qreal ratio = devicePixelRatioF();
  const QColor colour = vehicleColour(document_.site(), setup()->id, palette());
  dot_->setPixmap(dotIcon(colour, colour, side, ratio).pixmap(QSize{side, side}, ratio));
  name_->setText(name());
  name_->setFont(larger(font(), 1.25));
  state_->setFont(larger(font(), 1.1));
}

void RunPanel::showState(const supervisor::Snapshot* snapshot, const supervisor::VehicleView* view) {
  const QString now = situation(snapshot, view, name());
  if (sentence_->text() != now) sentence_->setText(now);
  const Condition condition = conditionOf(snapshot, view);
  if (shown_ == condition) return;
  shown_ = condition;
  const QColor colour = toneColour(toneOf(condition), palette());
  const int side = fontMetrics().height() * 5 / 4;
  const qreal ratio = devicePixelRatioF();
  stateIcon_->setPixmap(tintedIcon(iconName(condition), colour, side, ratio).pixmap(QSize{side, side}, ratio));
  state_->setText(words(condition));
  QPalette ink = palette();
  ink.setColor(QPalette::WindowText, colour);
  state_->setPalette(ink);
}

}  // namespace tessera::ui
