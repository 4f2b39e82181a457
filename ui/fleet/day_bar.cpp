#include "ui/fleet/day_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLocale>

#include "ui/base/icon.h"

namespace tessera::ui {

DayBar::DayBar(QWidget* parent) : QWidget{parent} {
  before_.setObjectName(QStringLiteral("dayBefore"));
  date_.setObjectName(QStringLiteral("dayField"));
  after_.setObjectName(QStringLiteral("dayAfter"));
  now_.setObjectName(QStringLiteral("backToNow"));
  before_.setIcon(icon(QStringLiteral("arrow-left")));
  after_.setIcon(icon(QStringLiteral("arrow-right")));
  for (QToolButton* button : {&before_, &after_}) {
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::StrongFocus);
  }
  date_.setCalendarPopup(true);
  // A date that is being typed is no date yet.
  date_.setKeyboardTracking(false);
  label_.setBuddy(&date_);
  auto* row = new QHBoxLayout{this};
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(&label_);
  row->addWidget(&before_);
  row->addWidget(&date_);
  row->addWidget(&after_);
  row->addStretch();
  row->addWidget(&now_);
  connect(&before_, &QToolButton::clicked, this, [this] { date_.setDate(day().addDays(-1)); });
  connect(&after_, &QToolButton::clicked, this, [this] { date_.setDate(day().addDays(1)); });
  connect(&now_, &QPushButton::clicked, this, &DayBar::left);
  connect(&date_, &QDateEdit::dateChanged, this, [this](const QDate& day) {
    showReach();
    Q_EMIT dayChosen(day);
  });
  retranslate();
}

void DayBar::begin() {
  const QSignalBlocker quiet{&date_};
  date_.setMaximumDate(QDate::currentDate());
  if (!begun_) date_.setDate(QDate::currentDate().addDays(-1));
  begun_ = true;
  showReach();
  date_.setFocus();
}

void DayBar::showReach() { after_.setEnabled(day() < date_.maximumDate()); }

void DayBar::retranslate() {
  label_.setText(tr("&Day:"));
  before_.setToolTip(tr("The day before"));
  before_.setAccessibleName(tr("The day before"));
  after_.setToolTip(tr("The day after"));
  after_.setAccessibleName(tr("The day after"));
  date_.setAccessibleName(tr("Day of the journal"));
  date_.setLocale(QLocale{});
  date_.setDisplayFormat(QLocale{}.dateFormat(QLocale::ShortFormat));
  now_.setText(tr("&Back to now"));
}

void DayBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange) retranslate();
  QWidget::changeEvent(event);
}

}  // namespace tessera::ui
