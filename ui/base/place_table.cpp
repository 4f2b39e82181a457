#include "ui/base/place_table.h"

#include <QHeaderView>
#include <algorithm>

namespace tessera::ui {

PlaceTable::PlaceTable(const char* objectName, QAbstractItemModel* places, QWidget* parent) : QTableView{parent} {
  setObjectName(QLatin1String{objectName});
  setMinimumHeight(4 * fontMetrics().height());
  setModel(places);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setTabKeyNavigation(false);
  horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  horizontalHeader()->setHighlightSections(false);  // bold may be wider than the column
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
  setContextMenuPolicy(Qt::ActionsContextMenu);
}

std::optional<std::size_t> PlaceTable::place() const {
  const QModelIndex index = currentIndex();
  return index.isValid() ? std::optional{static_cast<std::size_t>(index.row())} : std::nullopt;
}

void PlaceTable::setPlace(std::optional<std::size_t> place) {
  if (!place || *place >= static_cast<std::size_t>(model()->rowCount())) {
    clearSelection();
    setCurrentIndex({});
    return;
  }
  const int row = static_cast<int>(*place);
  int column = std::max(0, currentIndex().column());
  while (column > 0 && !model()->flags(model()->index(row, column)).testFlag(Qt::ItemIsEditable)) --column;
  setCurrentIndex(model()->index(row, column));
}

}  // namespace tessera::ui
