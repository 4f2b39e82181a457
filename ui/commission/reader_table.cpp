#include "ui/commission/reader_table.h"

#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLocale>
#include <QVBoxLayout>
#include <cmath>

namespace tessera::ui {
namespace {

constexpr std::size_t kMostReaders = 8;
constexpr double kFarthestReader = 10.0;  // m

}  // namespace

ReaderTable::ReaderTable(QWidget* parent) : QWidget{parent} {
  table_.setObjectName(QStringLiteral("readerTable"));
  table_.setColumnCount(2);
  table_.setSelectionBehavior(QAbstractItemView::SelectRows);
  table_.setSelectionMode(QAbstractItemView::SingleSelection);
  table_.horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_.verticalHeader()->setDefaultSectionSize(fontMetrics().height() * 3 / 2);
  table_.setMinimumHeight(fontMetrics().height() * 9);
  table_.setTabKeyNavigation(false);
  setFocusProxy(&table_);
  add_.setObjectName(QStringLiteral("addReader"));
  remove_.setObjectName(QStringLiteral("removeReader"));
  add_.setAutoDefault(false);
  remove_.setAutoDefault(false);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(&add_);
  buttons->addWidget(&remove_);
  buttons->addStretch();
  auto* column = new QVBoxLayout{this};
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(&table_, 1);
  column->addLayout(buttons);
  connect(&table_, &QTableWidget::cellChanged, this, &ReaderTable::takeCells);
  connect(&add_, &QPushButton::clicked, this, &ReaderTable::add);
  connect(&remove_, &QPushButton::clicked, this, &ReaderTable::removeCurrent);
  retranslate();
}

void ReaderTable::setReaders(const std::vector<Offset>& readers) {
  readers_ = readers;
  fill();
}

std::vector<Offset> ReaderTable::readers() const { return readers_; }

void ReaderTable::fill() {
  filling_ = true;
  table_.setRowCount(static_cast<int>(readers_.size()));
  for (int row = 0; row < table_.rowCount(); ++row) {
    const Offset& o = readers_[static_cast<std::size_t>(row)];
    int column = 0;
    for (const double value : {o.x.value(), o.y.value()}) {
      auto* item = new QTableWidgetItem;
      item->setData(Qt::EditRole, QLocale{}.toString(value, 'f', 3));
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      table_.setItem(row, column++, item);
    }
  }
  filling_ = false;
  add_.setEnabled(readers_.size() < kMostReaders);
  remove_.setEnabled(readers_.size() > 1);
}

// What is no number, or far from any vehicle, is put back as it was.
void ReaderTable::takeCells() {
  if (filling_) return;
  const auto number = [&](int row, int column, double old) {
    const QString text = table_.item(row, column)->text().trimmed();
    bool good = false;
    double value = QLocale{}.toDouble(text, &good);
    if (!good) value = QLocale::c().toDouble(text, &good);
    return good && std::abs(value) <= kFarthestReader ? value : old;
  };
  for (int row = 0; row < table_.rowCount(); ++row) {
    Offset& o = readers_[static_cast<std::size_t>(row)];
    o.x = Metres{number(row, 0, o.x.value())};
    o.y = Metres{number(row, 1, o.y.value())};
  }
  fill();
  Q_EMIT edited();
}

void ReaderTable::add() {
  if (readers_.size() >= kMostReaders) return;
  Offset next{Metres{0.15}, Metres{}};
  if (!readers_.empty()) next = {readers_.back().x, readers_.back().y - Metres{0.1}};
  readers_.push_back(next);
  fill();
  table_.setCurrentCell(table_.rowCount() - 1, 0);
  Q_EMIT edited();
}

void ReaderTable::removeCurrent() {
  if (readers_.size() <= 1) return;
  const int row = table_.currentRow() < 0 ? table_.rowCount() - 1 : table_.currentRow();
  readers_.erase(readers_.begin() + row);
  fill();
  Q_EMIT edited();
}

void ReaderTable::retranslate() {
  table_.setAccessibleName(tr("Places of the readers"));
  table_.setHorizontalHeaderLabels({tr("Ahead (m)"), tr("Left (m)")});
  table_.setToolTip(tr("How far ahead of the middle between the driven wheels, and how far to its left"));
  add_.setText(tr("Add a reader"));
  remove_.setText(tr("Remove it"));
  fill();
}

void ReaderTable::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

}  // namespace tessera::ui
