// Tags that belong to no tile as a table, a row each: UID, x and y in metres. Works on a list of its own.
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "floor/site.h"

namespace tessera::ui {

class LooseTagModel : public QAbstractTableModel {
  Q_OBJECT
public:
  enum Column { Uid, X, Y, Columns };
  static constexpr double kFarthest = 100'000.0;  ///< metres, as far as a site file goes

  explicit LooseTagModel(std::vector<floor::LooseTag> tags, QObject* parent = nullptr);

  [[nodiscard]] const std::vector<floor::LooseTag>& tags() const { return tags_; }
  /// Puts a tag without a UID at the end, at the place of the one before it. Gives its row.
  int add();
  void remove(int row);
  void retranslate();

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

Q_SIGNALS:
  /// What was typed is no UID; the row keeps what it had.
  void refused(const QString& sentence);
  /// A tag was added, removed or changed.
  void edited();

private:
  std::vector<floor::LooseTag> tags_;
};

}  // namespace tessera::ui
