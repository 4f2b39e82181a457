#include "ui/commission/jog_pad.h"

#include <QEvent>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <QStyleOptionFocusRect>
#include <chrono>

#include "ui/base/icon.h"

namespace tessera::ui {
namespace {

constexpr auto kJogEvery = std::chrono::milliseconds{100};
// The supervisor takes no Jog after a Stop until none has come for kJogHolds: a key pressed sooner waits that long.
constexpr int kPauseAfterStopMs = static_cast<int>(supervisor::kJogHolds.value() * 1000) + 50;
constexpr int kSlowestJogMm = 20;
constexpr int kFastestJogMm = static_cast<int>(supervisor::kJogFastest.value() * 1000 + 0.5);
// At the fastest, so that a turn on the spot is as lively as the drive.
constexpr double kTurnRadiansPerMetre = 4.0;

}  // namespace

JogPad::JogPad(FleetLink& link, Selection& selection, QWidget* parent)
    : QWidget{parent}, link_{link}, selection_{selection} {
  setObjectName(QStringLiteral("jogPad"));
  setProperty("helpTopic", QStringLiteral("commissioning"));
  setFocusPolicy(Qt::StrongFocus);
  repeat_.setInterval(kJogEvery);
  connect(&repeat_, &QTimer::timeout, this, &JogPad::send);
  layOut();
  for (const Arrow arrow : kArrows) {
    connect(&buttonOf(arrow), &QToolButton::pressed, this, [this, arrow] { press(arrow); });
    connect(&buttonOf(arrow), &QToolButton::released, this, [this, arrow] { release(arrow); });
  }
  connect(&slider_, &QSlider::valueChanged, this, &JogPad::retranslate);
  connect(&link_, &FleetLink::snapshotChanged, this, &JogPad::showState);
  connect(&selection_, &Selection::vehicleChanged, this, [this] {
    letGo();
    showState();
  });
  retranslate();
}

JogPad::~JogPad() { letGo(); }

void JogPad::layOut() {
  const int side = fontMetrics().height() * 3;
  const std::array<const char*, 4> icons{"arrow-up", "arrow-down", "turn-left", "turn-right"};
  const std::array<const char*, 4> names{"jogForward", "jogBackward", "jogLeft", "jogRight"};
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    buttons_[i].setObjectName(QLatin1String{names[i]});
    buttons_[i].setIcon(icon(QLatin1String{icons[i]}));
    buttons_[i].setIconSize({side / 2, side / 2});
    buttons_[i].setMinimumSize(side, side);
    buttons_[i].setFocusPolicy(Qt::NoFocus);  // the keyboard stays with the pad
  }
  slider_.setObjectName(QStringLiteral("jogSpeed"));
  slider_.setOrientation(Qt::Horizontal);
  slider_.setRange(kSlowestJogMm, kFastestJogMm);
  slider_.setSingleStep(5);
  slider_.setPageStep(20);
  slider_.setValue(50);
  slider_.setFocusPolicy(Qt::TabFocus);
  speedLabel_.setBuddy(&slider_);
  hint_.setObjectName(QStringLiteral("jogHint"));
  hint_.setWordWrap(true);
  hint_.setMinimumHeight(fontMetrics().lineSpacing() * 2);
  hint_.setAlignment(Qt::AlignTop | Qt::AlignHCenter);

  auto* grid = new QGridLayout{this};
  grid->addWidget(&buttonOf(kForward), 0, 2);
  grid->addWidget(&buttonOf(kLeft), 1, 1);
  grid->addWidget(&buttonOf(kBackward), 1, 2);
  grid->addWidget(&buttonOf(kRight), 1, 3);
  grid->addWidget(&hint_, 2, 0, 1, 5);
  grid->addWidget(&speedLabel_, 3, 0, 1, 5);
  grid->addWidget(&slider_, 4, 0, 1, 5);
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(4, 1);
  grid->setRowStretch(5, 1);
}

QToolButton& JogPad::buttonOf(Arrow arrow) {
  switch (arrow) {
    case kForward:
      return buttons_[0];
    case kBackward:
      return buttons_[1];
    case kLeft:
      return buttons_[2];
    case kRight:
      break;
  }
  return buttons_[3];
}

std::optional<JogPad::Arrow> JogPad::arrowOf(int key) {
  switch (key) {
    case Qt::Key_Up:
      return kForward;
    case Qt::Key_Down:
      return kBackward;
    case Qt::Key_Left:
      return kLeft;
    case Qt::Key_Right:
      return kRight;
    default:
      return std::nullopt;
  }
}

MetresPerSecond JogPad::speed() const { return MetresPerSecond{slider_.value() / 1000.0}; }

QString JogPad::obstacle() const {
  const auto picture = link_.latest();
  if (!picture) return tr("Not connected. Connect to the vehicles first.");
  const auto id = selection_.vehicle();
  const supervisor::VehicleView* vehicle = id ? picture->find(*id) : nullptr;
  if (vehicle == nullptr) return tr("Choose a vehicle first.");
  const QString name = QString::fromStdString(vehicle->name);
  if (vehicle->contact != supervisor::Contact::Connected) return tr("%1 is not in contact.").arg(name);
  if (vehicle->task == supervisor::Task::Running || vehicle->task == supervisor::Task::Paused)
    return tr("%1 has a route. Stop it first, then drive by hand.").arg(name);
  return {};
}

void JogPad::press(Arrow arrow) {
  if (!obstacle().isEmpty()) return;
  const bool first = held_ == 0;
  held_ |= arrow;
  refused_ = false;
  if (first) repeat_.start();
  send();
  showState();
}

void JogPad::release(Arrow arrow) {
  if ((held_ & arrow) == 0) return;
  held_ &= ~static_cast<unsigned>(arrow);
  if (held_ == 0)
    letGo();
  else
    send();
  showState();
}

// One Stop, whatever was held; without a Jog before it none is needed.
void JogPad::letGo() {
  held_ = 0;
  repeat_.stop();
  if (!moving_) return;
  link_.post(supervisor::Stop{*moving_});
  moving_.reset();
  stopped_.start();
}

void JogPad::send() {
  if (held_ == 0) return;
  if (stopped_.isValid() && stopped_.elapsed() < kPauseAfterStopMs) return;
  const auto sense = [&](Arrow plus, Arrow minus) {
    return ((held_ & plus) != 0 ? 1.0 : 0.0) - ((held_ & minus) != 0 ? 1.0 : 0.0);
  };
  const VehicleId id = *selection_.vehicle();
  const double turn = speed().value() * kTurnRadiansPerMetre * sense(kLeft, kRight);
  moving_ = id;
  if (!link_.post(supervisor::Jog{id, speed() * sense(kForward, kBackward), RadiansPerSecond{turn}})) {
    letGo();
    refused_ = true;
    showState();
    return;
  }
  Q_EMIT driven();
}

void JogPad::keyPressEvent(QKeyEvent* event) {
  const auto arrow = arrowOf(event->key());
  if (!arrow) {
    QWidget::keyPressEvent(event);
    return;
  }
  if (!event->isAutoRepeat()) press(*arrow);
}

void JogPad::keyReleaseEvent(QKeyEvent* event) {
  const auto arrow = arrowOf(event->key());
  if (!arrow) {
    QWidget::keyReleaseEvent(event);
    return;
  }
  if (!event->isAutoRepeat()) release(*arrow);
}

void JogPad::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  showState();
}

void JogPad::focusOutEvent(QFocusEvent* event) {
  letGo();
  QWidget::focusOutEvent(event);
  showState();
}

void JogPad::mousePressEvent(QMouseEvent* event) {
  setFocus(Qt::MouseFocusReason);
  QWidget::mousePressEvent(event);
}

void JogPad::hideEvent(QHideEvent* event) {
  letGo();
  QWidget::hideEvent(event);
}

bool JogPad::event(QEvent* event) {
  if (event->type() == QEvent::WindowDeactivate) letGo();
  return QWidget::event(event);
}

void JogPad::changeEvent(QEvent* event) {
  if (event->type() == QEvent::EnabledChange && !isEnabled()) letGo();
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void JogPad::showState() {
  const QString reason = obstacle();
  if (!reason.isEmpty() && held_ != 0) letGo();
  for (QToolButton& button : buttons_) button.setEnabled(reason.isEmpty());
  if (!reason.isEmpty())
    hint_.setText(reason);
  else if (refused_)
    hint_.setText(tr("The order was not taken. Let go and try again."));
  else if (held_ != 0)
    hint_.setText(tr("Driving. Let go to stop."));
  else if (hasFocus())
    hint_.setText(tr("Hold an arrow key or an arrow button to move. Let go to stop."));
  else
    hint_.setText(tr("Hold an arrow button to move, or click here and hold an arrow key. Let go to stop."));
  update();
}

void JogPad::paintEvent(QPaintEvent* /*event*/) {
  if (!hasFocus()) return;
  QPainter painter{this};
  QStyleOptionFocusRect option;
  option.initFrom(this);
  style()->drawPrimitive(QStyle::PE_FrameFocusRect, &option, &painter, this);
}

void JogPad::retranslate() {
  setAccessibleName(tr("Drive by hand"));
  const std::array<QString, 4> texts{tr("Forwards (↑)"), tr("Backwards (↓)"), tr("Turn left (←)"),
                                     tr("Turn right (→)")};
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    buttons_[i].setToolTip(tr("%1: moves while it is held").arg(texts[i]));
    buttons_[i].setAccessibleName(texts[i]);
  }
  speedLabel_.setText(tr("&Speed: %1 m/s").arg(QLocale{}.toString(speed().value(), 'f', 3)));
  slider_.setAccessibleName(tr("Speed by hand"));
  showState();
}

}  // namespace tessera::ui
