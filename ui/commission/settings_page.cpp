#include "ui/commission/settings_page.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>

namespace tessera::ui {
namespace {

std::int32_t wireUnits(double value, double perUnit) { return static_cast<std::int32_t>(std::lround(value * perUnit)); }

}  // namespace

std::vector<WantedSetting> wantedSettings(const floor::VehicleSetup& v) {
  using wire::Parameter;
  return {{Parameter::WheelDiameter, wireUnits(v.wheelDiameter.value(), 1e6)},
          {Parameter::TrackWidth, wireUnits(v.track.value(), 1e6)},
          {Parameter::MaxSpeed, wireUnits(v.maxSpeed.value(), 1e3)},
          {Parameter::MaxTurnRate, wireUnits(v.maxTurnRate.value(), 1e3)},
          {Parameter::Acceleration, wireUnits(v.acceleration.value(), 1e3)},
          {Parameter::ReaderCount, static_cast<std::int32_t>(v.readers.size())}};
}

SettingsPage::SettingsPage(Commissioning& work, QWidget* parent)
    : StepPage{work, Commissioning::Step::Settings, Needs::Vehicle, parent}, series_{work.link()} {
  table_.setObjectName(QStringLiteral("settingsTable"));
  table_.setColumnCount(3);
  table_.verticalHeader()->hide();
  table_.setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_.setSelectionMode(QAbstractItemView::NoSelection);
  table_.setFocusPolicy(Qt::NoFocus);
  table_.horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  read_.setObjectName(QStringLiteral("readSettings"));
  write_.setObjectName(QStringLiteral("writeSettings"));
  result_.setObjectName(QStringLiteral("settingsResult"));
  auto* buttons = new QHBoxLayout;
  for (QPushButton* button : {&read_, &write_}) {
    button->setAutoDefault(false);
    buttons->addWidget(button);
  }
  buttons->addStretch();
  content().addWidget(&table_, 1);
  content().addLayout(buttons);
  content().addWidget(&result_);
  connect(&read_, &QPushButton::clicked, this, [this] { ask(wire::MessageType::Get); });
  connect(&write_, &QPushButton::clicked, this, [this] { ask(wire::MessageType::Set); });
  connect(&series_, &AskSeries::answered, this, &SettingsPage::showAnswer);
  connect(&series_, &AskSeries::finished, this, &SettingsPage::finish);
  connect(&series_, &AskSeries::failed, this, [this](const QString& sentence) {
    result_.show(Notice::Tone::Error, sentence);
    refresh(reachable_ ? this->work().view() : nullptr);
  });
}

void SettingsPage::initializePage() {
  wanted_ = wantedSettings(work().draft());
  held_.assign(wanted_.size(), std::nullopt);
  askedOnce_ = false;
  result_.clear();
  StepPage::initializePage();
  fill();
}

void SettingsPage::hideEvent(QHideEvent* event) {
  if (series_.isRunning()) askedOnce_ = false;
  series_.stop();
  StepPage::hideEvent(event);
}

void SettingsPage::ask(wire::MessageType type) {
  std::vector<wire::Request> requests;
  for (const WantedSetting& s : wanted_)
    requests.push_back({type, static_cast<std::uint8_t>(s.parameter), type == wire::MessageType::Set ? s.value : 0});
  result_.show(Notice::Tone::Info, type == wire::MessageType::Set ? tr("Writing…") : tr("Reading…"));
  series_.start(work().address(), requests);
  refresh(reachable_ ? work().view() : nullptr);
}

void SettingsPage::refresh(const supervisor::VehicleView* vehicle) {
  reachable_ = vehicle != nullptr;
  read_.setEnabled(reachable_ && !series_.isRunning());
  write_.setEnabled(reachable_ && !series_.isRunning());
  if (reachable_ && !askedOnce_) {
    askedOnce_ = true;
    ask(wire::MessageType::Get);
  }
}

void SettingsPage::showAnswer(std::size_t index, const supervisor::AskAnswer& answer) {
  if (index >= held_.size()) return;
  const bool known = answer.value->outcome != wire::Outcome::Unknown;
  held_[index] = known ? std::optional{answer.value->value} : std::nullopt;
  fill();
}

bool SettingsPage::allRight() const {
  for (std::size_t i = 0; i < wanted_.size(); ++i)
    if (held_[i] != wanted_[i].value) return false;
  return true;
}

void SettingsPage::finish() {
  markDone(allRight());
  if (allRight())
    result_.show(Notice::Tone::Good, tr("The vehicle holds the settings of its type."));
  else
    result_.show(Notice::Tone::Warning,
                 tr("The marked settings differ. Press “Write to the vehicle”; if one stays, it is out of the range "
                    "that the vehicle accepts, and the type must be corrected."));
  refresh(reachable_ ? work().view() : nullptr);
}

void SettingsPage::fill() {
  struct Kind {
    QString name;
    QString unit;
    double perUnit;
    int decimals;
  };
  const std::array<Kind, 6> kinds{{{tr("Wheel diameter"), tr("%1 m"), 1e6, 4},
                                   {tr("Track (wheel to wheel)"), tr("%1 m"), 1e6, 3},
                                   {tr("Highest speed"), tr("%1 m/s"), 1e3, 2},
                                   {tr("Highest turn rate"), tr("%1 rad/s"), 1e3, 2},
                                   {tr("Acceleration"), tr("%1 m/s²"), 1e3, 2},
                                   {tr("Number of readers"), QStringLiteral("%1"), 1, 0}}};
  table_.setRowCount(static_cast<int>(wanted_.size()));
  QColor mark{0xe0, 0x9a, 0x10};
  mark.setAlphaF(0.25F);
  for (std::size_t i = 0; i < wanted_.size(); ++i) {
    const Kind& kind = kinds[i];
    const auto shown = [&](std::int32_t v) {
      return kind.unit.arg(QLocale{}.toString(v / kind.perUnit, 'f', kind.decimals));
    };
    const QString held = held_[i] ? shown(*held_[i]) : tr("not read yet");
    int column = 0;
    for (const QString& value : {kind.name, shown(wanted_[i].value), held}) {
      auto* item = new QTableWidgetItem{value};
      if (held_[i] && *held_[i] != wanted_[i].value) item->setBackground(mark);
      table_.setItem(static_cast<int>(i), column++, item);
    }
  }
}

void SettingsPage::retranslate() {
  setTitle(tr("Settings onto the vehicle"));
  setSubTitle(tr("The vehicle needs the measures of its type to drive the speeds that it is told."));
  table_.setAccessibleName(tr("Settings of the site and of the vehicle"));
  table_.setHorizontalHeaderLabels({tr("Setting"), tr("Site"), tr("Vehicle")});
  read_.setText(tr("&Read from the vehicle"));
  write_.setText(tr("&Write to the vehicle"));
  fill();
  StepPage::retranslate();
}

}  // namespace tessera::ui
