// Places of one thing as a table, a row each: vertices of a route, corners of a zone.
#pragma once

#include <QTableView>
#include <optional>

namespace tessera::ui {

class PlaceTable : public QTableView {
  Q_OBJECT
public:
  PlaceTable(const char* objectName, QAbstractItemModel* places, QWidget* parent = nullptr);

  /// The current row; nullopt: none.
  [[nodiscard]] std::optional<std::size_t> place() const;
  /// A row that there is not is none. Stays in its column where that can be edited.
  void setPlace(std::optional<std::size_t> place);
};

}  // namespace tessera::ui
