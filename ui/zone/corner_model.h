// The corners of the chosen zone as a table: number, place in centimetres, length of the edge to the next one.
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "ui/zone/zone_edits.h"

namespace tessera::ui {

class CornerModel : public QAbstractTableModel {
  Q_OBJECT
public:
  enum Column { kX, kY, kEdge, kColumns };

  CornerModel(SiteDocument& document, QObject* parent);

  /// Empty: none. Takes over what the document says now; rows keep their identity while their number stays.
  void setZone(const QString& zone);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  void retranslate() { Q_EMIT headerDataChanged(Qt::Horizontal, 0, kColumns - 1); }

Q_SIGNALS:
  void refused(const QString& sentence);

private:
  ZoneEdits edits_;
  QString zone_;
  std::vector<Point> corners_;
};

}  // namespace tessera::ui
