#include "ui/fleet/event_panel.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/base/icon.h"
#include "ui/fleet/vehicle_delegate.h"

namespace tessera::ui {

EventPanel::EventPanel(FleetLink& link, Selection& selection, SiteDocument& document, QWidget* parent)
    : QWidget{parent}, link_{link}, selection_{selection}, document_{document}, model_{document}, past_{document} {
  setObjectName(QStringLiteral("eventPanel"));
  shown_.setSourceModel(&model_);
  build();
  connect(&link_, &FleetLink::eventsArrived, this, [this](const std::vector<supervisor::Event>& events) {
    model_.append(events);
    if (showsDay()) return;
    showWhatThereIs();
    if (atEnd_) view_->scrollToBottom();
  });
  connect(&document_, &SiteDocument::changed, this, [this] {
    QStringList listed;
    for (int i = 1; i < vehicle_->count(); ++i) listed.append(vehicle_->itemText(i));
    QStringList names;
    for (const auto& v : document_.site().vehicles) names.append(QString::fromStdString(v.name));
    if (names != listed) takeVehicles();  // routes are edited far more often
  });
  retranslate();
  sizeColumns();
}

QToolButton* EventPanel::makeButton(const QString& name, const QString& iconName, void (EventPanel::*does)()) {
  auto* button = new QToolButton{this};
  button->setObjectName(name);
  button->setIcon(icon(iconName));
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::StrongFocus);
  connect(button, &QToolButton::clicked, this, does);
  return button;
}

// Hiding its children is the last thing that a widget does, and moves the bar once more.
EventPanel::~EventPanel() { view_->verticalScrollBar()->disconnect(this); }

void EventPanel::build() {
  severity_ = new QComboBox{this};
  severity_->setObjectName(QStringLiteral("severityFilter"));
  vehicle_ = new QComboBox{this};
  vehicle_->setObjectName(QStringLiteral("vehicleFilter"));
  words_ = new QLineEdit{this};
  words_->setObjectName(QStringLiteral("wordsFilter"));
  words_->setClearButtonEnabled(true);
  words_->addAction(icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
  for (QComboBox* choice : {severity_, vehicle_}) {
    connect(choice, &QComboBox::currentIndexChanged, this, &EventPanel::filter);
    connect(choice, &QComboBox::currentIndexChanged, this, [this] {
      if (showsDay()) askForDay();
    });
  }
  connect(words_, &QLineEdit::textChanged, this, &EventPanel::filter);
  toEnd_ = makeButton(QStringLiteral("toEndButton"), QStringLiteral("to-end"), &EventPanel::goToEnd);
  copy_ = makeButton(QStringLiteral("copyEventsButton"), QStringLiteral("copy"), &EventPanel::copy);
  save_ = makeButton(QStringLiteral("saveEventsButton"), QStringLiteral("export"), &EventPanel::save);
  byDay_ = new QToolButton{this};
  byDay_->setObjectName(QStringLiteral("byDayButton"));
  byDay_->setIcon(icon(QStringLiteral("journal")));
  byDay_->setAutoRaise(true);
  byDay_->setCheckable(true);
  byDay_->setFocusPolicy(Qt::StrongFocus);
  connect(byDay_, &QToolButton::toggled, this, &EventPanel::chooseDay);
  days_ = new DayBar{this};
  days_->hide();
  connect(days_, &DayBar::dayChosen, this, &EventPanel::askForDay);
  connect(days_, &DayBar::left, this, [this] { byDay_->setChecked(false); });
  tooMany_ = new Notice{this};
  clear_ = makeButton(QStringLiteral("clearEventsButton"), QStringLiteral("delete"), &EventPanel::clear);

  view_ = new QTreeView{this};
  view_->setObjectName(QStringLiteral("eventList"));
  view_->setModel(&shown_);
  view_->setItemDelegate(new VehicleDelegate{view_});
  view_->setRootIsDecorated(false);
  view_->setUniformRowHeights(true);
  view_->setAllColumnsShowFocus(true);
  view_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  view_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  view_->setFrameShape(QFrame::NoFrame);
  auto* copyKey = new QAction{view_};
  copyKey->setShortcut(QKeySequence::Copy);
  copyKey->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  connect(copyKey, &QAction::triggered, this, &EventPanel::copy);
  view_->addAction(copyKey);
  connect(view_, &QAbstractItemView::activated, this, [this](const QModelIndex& index) {
    const QVariant vehicle = index.data(VehicleRole);
    if (vehicle.isValid()) selection_.setVehicle(VehicleId{static_cast<std::uint8_t>(vehicle.toInt())});
  });
  // Only a hand on the bar, wheel or keys changes it: a range that grows with new lines leaves the value where it was.
  connect(view_->verticalScrollBar(), &QScrollBar::valueChanged, this, [this](int value) {
    atEnd_ = value >= view_->verticalScrollBar()->maximum();
    toEnd_->setEnabled(!atEnd_);
  });
  connect(view_->verticalScrollBar(), &QScrollBar::rangeChanged, this, [this](int /*least*/, int most) {
    if (atEnd_) view_->verticalScrollBar()->setValue(most);
  });
  toEnd_->setEnabled(false);

  nothing_ = new FleetHint{QStringLiteral("journal"), this};
  nothing_->button()->setObjectName(QStringLiteral("showAllButton"));
  connect(nothing_->button(), &QPushButton::clicked, this, &EventPanel::showAll);
  auto* bar = new QHBoxLayout;
  bar->addWidget(severity_);
  bar->addWidget(vehicle_);
  bar->addWidget(words_, 1);
  bar->addWidget(byDay_);
  bar->addWidget(toEnd_);
  bar->addWidget(copy_);
  bar->addWidget(save_);
  bar->addWidget(clear_);
  auto* below = new QWidget{this};
  pages_ = new QStackedLayout{below};
  pages_->addWidget(view_);
  pages_->addWidget(nothing_);
  auto* column = new QVBoxLayout{this};
  column->addLayout(bar);
  column->addWidget(days_);
  column->addWidget(tooMany_);
  column->addWidget(below, 1);
}

void EventPanel::retranslate() {
  const int severity = std::max(0, severity_->currentIndex());
  {
    const QSignalBlocker quiet{severity_};
    severity_->clear();
    severity_->addItem(icon(QStringLiteral("info")), tr("Everything"), static_cast<int>(supervisor::Severity::Info));
    severity_->addItem(icon(QStringLiteral("warning")), tr("Warnings and errors"),
                       static_cast<int>(supervisor::Severity::Warning));
    severity_->addItem(icon(QStringLiteral("error")), tr("Errors only"), static_cast<int>(supervisor::Severity::Error));
    severity_->setCurrentIndex(severity);
  }
  severity_->setToolTip(tr("How serious an event must be to be listed."));
  severity_->setAccessibleName(tr("Severity"));
  vehicle_->setToolTip(tr("Whose events are listed."));
  vehicle_->setAccessibleName(tr("Vehicle"));
  words_->setPlaceholderText(tr("Search"));
  words_->setAccessibleName(tr("Search"));
  toEnd_->setToolTip(tr("Go to the newest event and stay there."));
  toEnd_->setAccessibleName(tr("Go to the end"));
  copy_->setToolTip(tr("Copy the selected events, or all that are listed (%1)")
                        .arg(QKeySequence{QKeySequence::Copy}.toString(QKeySequence::NativeText)));
  copy_->setAccessibleName(tr("Copy"));
  save_->setToolTip(tr("Save all that are listed as a table (CSV)"));
  save_->setAccessibleName(tr("Save as a table"));
  byDay_->setToolTip(tr("Show a day of the journal"));
  byDay_->setAccessibleName(tr("Show a day of the journal"));
  clear_->setToolTip(tr("Empty this list. The journal keeps what happened."));
  clear_->setAccessibleName(tr("Empty the list"));
  view_->setAccessibleName(tr("What happened"));
  model_.refreshTexts();
  past_.refreshTexts();
  takeVehicles();
}

void EventPanel::takeVehicles() {
  const QVariant chosen = vehicle_->currentData();
  {
    const QSignalBlocker quiet{vehicle_};
    vehicle_->clear();
    vehicle_->addItem(icon(QStringLiteral("vehicle")), tr("All vehicles"));
    for (const auto& v : document_.site().vehicles)
      vehicle_->addItem(QString::fromStdString(v.name), static_cast<int>(v.id.value));
    vehicle_->setCurrentIndex(std::max(0, chosen.isValid() ? vehicle_->findData(chosen) : 0));
  }
  filter();
}

void EventPanel::filter() {
  std::optional<VehicleId> vehicle;
  if (const QVariant id = vehicle_->currentData(); id.isValid())
    vehicle = VehicleId{static_cast<std::uint8_t>(id.toInt())};
  shown_.set(static_cast<supervisor::Severity>(severity_->currentData().toInt()), vehicle, words_->text());
  showWhatThereIs();
  if (atEnd_) view_->scrollToBottom();
}

void EventPanel::showAll() {
  if (showsDay() && past_.rowCount() == 0 && !shown_.isActive()) {
    byDay_->setChecked(false);
    return;
  }
  const QSignalBlocker quiet{words_};
  words_->clear();
  severity_->setCurrentIndex(0);
  vehicle_->setCurrentIndex(0);
  filter();
  if (showsDay()) askForDay();
}

void EventPanel::goToEnd() {
  atEnd_ = true;
  toEnd_->setEnabled(false);
  view_->scrollToBottom();
}

void EventPanel::showWhatThereIs() {
  const bool some = shown_.rowCount() > 0;
  pages_->setCurrentIndex(some ? 0 : 1);
  copy_->setEnabled(some);
  save_->setEnabled(some);
  clear_->setEnabled(!showsDay() && model_.rowCount() > 0);
  if (some) return;
  if (showsDay() && reading_) {
    nothing_->setTexts(tr("Reading the journal…"));
  } else if (!failure_.isEmpty() && showsDay()) {
    nothing_->setTexts(failure_, tr("Go back to &now"));
  } else if (shown_.isActive() && (showsDay() || model_.rowCount() > 0)) {
    nothing_->setTexts(tr("No event matches what is asked for above."), tr("Show &all"));
  } else if (showsDay()) {
    nothing_->setTexts(tr("Nothing was written into the journal on this day. Choose another one, or go back to now."),
                       tr("Go back to &now"));
  } else {
    nothing_->setTexts(tr("Nothing has happened yet. What vehicles do and what goes wrong is told here."));
  }
}

void EventPanel::prepend(const std::vector<JournalLine>& history) {
  model_.prepend(history);
  sizeColumns();
  showWhatThereIs();
  if (atEnd_) view_->scrollToBottom();
}

void EventPanel::clear() {
  model_.clear();
  goToEnd();
  showWhatThereIs();
}

void EventPanel::sizeColumns() {
  const QFontMetrics metrics = view_->fontMetrics();
  const int space = metrics.height();
  int time = metrics.horizontalAdvance(QStringLiteral("00:00:00"));
  if (listed().rowCount() > 0)  // the oldest one may need its date
    time = std::max(time, metrics.horizontalAdvance(listed().index(0, EventModel::When).data().toString()));
  view_->setColumnWidth(EventModel::When, time + space);
  view_->setColumnWidth(EventModel::Who, metrics.horizontalAdvance(QStringLiteral("AGV 100")) + space);
}

void EventPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange) retranslate();
  if (event->type() == QEvent::FontChange || event->type() == QEvent::LanguageChange) sizeColumns();
  QWidget::changeEvent(event);
}

}  // namespace tessera::ui
