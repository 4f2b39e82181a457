// The vertices of the chosen route as a table: number, place in metres, way from the one before and highest speed on
// it.
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "ui/route/route_edits.h"

namespace tessera::ui {

class VertexModel : public QAbstractTableModel {
  Q_OBJECT
public:
  enum Column { kX, kY, kLeg, kSpeed, kColumns };

  VertexModel(SiteDocument& document, QObject* parent);

  /// Empty: none. Rows keep their identity while the route keeps its number of vertices.
  void setRoute(const QString& route);
  /// Takes over what the document says now.
  void refresh();

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
  bool setSpeed(std::size_t vertex, const QVariant& value);
  [[nodiscard]] std::optional<MetresPerSecond> speedTo(std::size_t vertex) const;

  RouteEdits edits_;
  QString name_;
  floor::Route route_;
};

}  // namespace tessera::ui
