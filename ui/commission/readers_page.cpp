#include "ui/commission/readers_page.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <algorithm>

namespace tessera::ui {
namespace {

constexpr Seconds kReaderLight{1.5};
enum ReaderColumn { kReader, kAnswers, kTag, kKnown, kReaderColumns };

}  // namespace

ReadersPage::ReadersPage(Commissioning& work, QWidget* parent)
    : StepPage{work, Commissioning::Step::Readers, Needs::Vehicle, parent} {
  table_.setObjectName(QStringLiteral("readersTable"));
  table_.setColumnCount(kReaderColumns);
  table_.verticalHeader()->hide();
  table_.setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_.setSelectionMode(QAbstractItemView::NoSelection);
  table_.setFocusPolicy(Qt::NoFocus);
  table_.horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_.horizontalHeader()->setSectionResizeMode(kTag, QHeaderView::Stretch);
  preview_.setMaximumWidth(fontMetrics().height() * 14);
  result_.setObjectName(QStringLiteral("readersResult"));
  hint_.setWordWrap(true);
  auto* row = new QHBoxLayout;
  row->addWidget(&table_, 2);
  row->addWidget(&preview_, 1);
  content().addWidget(&hint_);
  content().addLayout(row, 1);
  content().addWidget(&result_);
}

void ReadersPage::initializePage() {
  since_.reset();
  seen_ = 0;
  preview_.setVehicle(work().draft());
  preview_.setAlight(0);
  StepPage::initializePage();
  fill(nullptr);
}

void ReadersPage::refresh(const supervisor::VehicleView* vehicle) {
  const auto picture = work().link().latest();
  unsigned alight = 0;
  if (vehicle != nullptr && picture) {
    if (!since_) since_ = picture->time;
    for (const supervisor::ReadView& read : vehicle->recentReads) {
      if (read.reader >= work().draft().readers.size() || read.at < *since_) continue;
      seen_ |= 1U << read.reader;
      if (picture->time - read.at < kReaderLight) alight |= 1U << read.reader;
    }
  }
  preview_.setAlight(alight);
  fill(vehicle);
  const auto count = work().draft().readers.size();
  const unsigned all = (1U << count) - 1;
  if (vehicle == nullptr) {
    result_.clear();
  } else if ((vehicle->readersAnswering & all) != all) {
    result_.show(Notice::Tone::Error, tr("A reader does not answer the vehicle. Check its cable, its supply and its "
                                         "number on the bus."));
  } else if (seen_ == all) {
    result_.show(Notice::Tone::Good, tr("Every reader has read a tag."));
    markDone();
  } else {
    int left = 0;
    for (std::size_t i = 0; i < count; ++i) left += ((seen_ >> i) & 1U) == 0 ? 1 : 0;
    result_.show(Notice::Tone::Info, tr("%n reader(s) still to try.", nullptr, left));
  }
}

void ReadersPage::fill(const supervisor::VehicleView* vehicle) {
  const int count = static_cast<int>(work().draft().readers.size());
  table_.setRowCount(count);
  for (int i = 0; i < count; ++i) {
    QString tag = tr("none yet");
    QString known;
    if (vehicle != nullptr && since_) {
      for (const supervisor::ReadView& read : vehicle->recentReads) {
        if (read.reader != i || read.at < *since_) continue;
        tag = QString::fromStdString(read.uid.text());
        known = read.place ? tr("yes") : tr("no");
      }
    }
    const bool answers = vehicle != nullptr && ((vehicle->readersAnswering >> i) & 1U) != 0;
    const QString said = vehicle == nullptr ? tr("–", "no value") : answers ? tr("yes") : tr("no");
    int column = 0;
    for (const QString& value : {tr("Reader %1").arg(i + 1), said, tag, known}) {
      if (table_.item(i, column) == nullptr) table_.setItem(i, column, new QTableWidgetItem);
      table_.item(i, column++)->setText(value);
    }
    QColor light{0x22, 0xa0, 0x5a};
    light.setAlphaF(0.25F);
    table_.item(i, kReader)->setBackground(((seen_ >> i) & 1U) != 0 ? QBrush{light} : QBrush{});
  }
}

void ReadersPage::retranslate() {
  setTitle(tr("The readers"));
  setSubTitle(tr("Hold a tag under one reader after the other, counted from the vehicle's left."));
  hint_.setText(
      tr("Under the right reader its light comes on in the drawing. If another one lights up, the readers are "
         "connected in another order than the type says."));
  table_.setAccessibleName(tr("Readers and the tags that they read"));
  table_.setHorizontalHeaderLabels({tr("Reader"), tr("Answers"), tr("Last tag"), tr("On this floor")});
  StepPage::retranslate();
}

}  // namespace tessera::ui
