#include "ui/base/name_list.h"

#include <algorithm>

namespace tessera::ui {
namespace {

constexpr int kMostRows = 3;                  // that are seen whole, however little room there is
constexpr int kKnownNameRole = Qt::UserRole;  // as the document has it, while the item's text is being edited

}  // namespace

NameList::NameList(const char* objectName, QWidget* parent) : QListWidget{parent} {
  setObjectName(QLatin1String{objectName});
  setMinimumHeight(2 * fontMetrics().height() + 8);
  setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  setContextMenuPolicy(Qt::ActionsContextMenu);
  connect(this, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
    if (!filling_ && item != nullptr) Q_EMIT nameChosen(item->text());
  });
  connect(this, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
    const QString known = item->data(kKnownNameRole).toString();
    if (!filling_ && item->text() != known) Q_EMIT renameRequested(known, item->text());
  });
}

QString NameList::setNames(const QStringList& names, const QString& chosen) {
  filling_ = true;
  const int before = currentRow();
  const bool sameCount = count() == names.size();
  const bool wasChosen = before >= 0 && item(before)->data(kKnownNameRole) == chosen;
  while (count() > names.size()) delete takeItem(count() - 1);
  for (int row = 0; row < names.size(); ++row) {
    if (row == count()) addItem(new QListWidgetItem);
    QListWidgetItem* known = item(row);
    known->setFlags(known->flags() | Qt::ItemIsEditable);
    known->setText(names[row]);
    known->setData(kKnownNameRole, names[row]);
  }
  const int row = static_cast<int>(names.indexOf(chosen));
  if (row < 0) {
    setCurrentRow(-1);
    clearSelection();
  } else if (currentRow() != row || !item(row)->isSelected()) {
    setCurrentRow(row);
  }
  filling_ = false;
  if (count() > 0) setMinimumHeight(std::clamp(count(), 2, kMostRows) * sizeHintForRow(0) + 2 * frameWidth());
  if (row >= 0 || chosen.isEmpty()) return chosen;
  return sameCount && wasChosen ? names[before] : QString{};
}

void NameList::startRenaming() {
  if (QListWidgetItem* current = currentItem()) {
    setFocus();
    editItem(current);
  }
}

}  // namespace tessera::ui
