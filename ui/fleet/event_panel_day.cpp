// Days of the journal in the list of events, and what leaves the list: to the clipboard, into a file.
#include <QClipboard>
#include <QGuiApplication>
#include <algorithm>

#include "ui/fleet/event_panel.h"
#include "ui/fleet/save_events.h"

namespace tessera::ui {

void EventPanel::chooseDay(bool on) {
  days_->setVisible(on);
  shown_.setSourceModel(on ? &past_ : &model_);
  toEnd_->setVisible(!on);
  tooMany_->clear();
  atEnd_ = !on;
  if (on) {
    days_->begin();
    askForDay();
  } else {
    past_.clear();
    reading_ = false;
    goToEnd();
  }
  sizeColumns();
  showWhatThereIs();
}

void EventPanel::askForDay() {
  past_.clear();
  tooMany_->clear();
  failure_.clear();
  reading_ = true;
  showWhatThereIs();
  JournalDay wish;
  wish.day = days_->day();
  wish.least = static_cast<supervisor::Severity>(severity_->currentData().toInt());
  if (const QVariant id = vehicle_->currentData(); id.isValid())
    wish.vehicle = VehicleId{static_cast<std::uint8_t>(id.toInt())};
  Q_EMIT dayWanted(wish);
}

// What is being looked at stays where it is while earlier lines come before it.
void EventPanel::showDay(const std::vector<JournalLine>& lines, JournalPart part) {
  if (!showsDay()) return;
  const bool first = past_.rowCount() == 0;
  const QPersistentModelIndex top = view_->indexAt({0, 0});
  past_.prepend(lines);
  reading_ = part == JournalPart::Page;
  if (first) sizeColumns();
  showWhatThereIs();
  if (first)
    view_->scrollToBottom();
  else if (top.isValid())
    view_->scrollTo(top, QAbstractItemView::PositionAtTop);
  if (part == JournalPart::TooMany)
    tooMany_->show(Notice::Tone::Info, tr("The last %n events of this day are listed. Choose a severity or a vehicle "
                                          "to see the earlier ones.",
                                          nullptr, past_.rowCount()));
}

void EventPanel::showDayFailure(const QString& sentence) {
  if (!showsDay()) return;
  reading_ = false;
  failure_ = sentence;
  showWhatThereIs();
}

void EventPanel::save() {
  const QString day = (showsDay() ? days_->day() : QDate::currentDate()).toString(Qt::ISODate);
  askAndSaveEvents(*this, shown_, QStringLiteral("%1 %2").arg(QString::fromStdString(document_.site().name), day));
}

void EventPanel::copy() {
  QModelIndexList rows = view_->selectionModel()->selectedRows();
  std::sort(rows.begin(), rows.end());
  if (rows.isEmpty())
    for (int row = 0; row < shown_.rowCount(); ++row) rows.append(shown_.index(row, 0));
  QStringList lines;
  for (const QModelIndex& row : rows) {
    QStringList cells;
    for (int column = 0; column < EventModel::ColumnCount; ++column)
      cells.append(row.siblingAtColumn(column).data().toString());
    lines.append(cells.join(QLatin1Char('\t')));
  }
  QGuiApplication::clipboard()->setText(lines.join(QLatin1Char('\n')));
}

}  // namespace tessera::ui
