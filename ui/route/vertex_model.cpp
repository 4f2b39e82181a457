#include "ui/route/vertex_model.h"

#include <QLocale>

#include "ui/base/wording.h"

namespace tessera::ui {

VertexModel::VertexModel(SiteDocument& document, QObject* parent) : QAbstractTableModel{parent}, edits_{document} {}

void VertexModel::setRoute(const QString& route) {
  route_ = route;
  refresh();
}

void VertexModel::refresh() {
  const floor::Route* route = edits_.find(route_);
  const std::vector<Point> now = route != nullptr ? route->vertices : std::vector<Point>{};
  if (now.size() != vertices_.size()) {
    beginResetModel();
    vertices_ = now;
    endResetModel();
  } else if (now != vertices_) {
    vertices_ = now;
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
  }
}

int VertexModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(vertices_.size());
}

int VertexModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant VertexModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const auto n = static_cast<std::size_t>(index.row());
  if (role == Qt::TextAlignmentRole) return QVariant::fromValue<int>(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole && role != Qt::EditRole) return {};
  if (index.column() == kLeg) {
    if (n == 0) return {};
    return QLocale().toString(distance(vertices_[n - 1], vertices_[n]).value(), 'f', 3);
  }
  const double value = (index.column() == kX ? vertices_[n].x : vertices_[n].y).value();
  if (role == Qt::EditRole) return value;
  return QLocale().toString(value, 'f', 3);
}

QVariant VertexModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Vertical) return role == Qt::DisplayRole ? QVariant{section + 1} : QVariant{};
  if (role == Qt::ToolTipRole) {
    if (section == kLeg) return tr("Length of the leg from the vertex before");
    return tr("Place in the site, in metres");
  }
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case kX:
      return tr("x (m)");
    case kY:
      return tr("y (m)");
    default:
      return tr("Leg (m)");
  }
}

bool VertexModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || !index.isValid() || index.row() >= rowCount() || index.column() == kLeg) return false;
  bool isNumber = false;
  const double metres = value.toDouble(&isNumber);
  if (!isNumber) return false;
  const auto n = static_cast<std::size_t>(index.row());
  Point place = vertices_[n];
  // What was not edited stays to the last digit.
  const Point edited = tidy({Metres{metres}, Metres{metres}});
  (index.column() == kX ? place.x : place.y) = edited.x;
  if (QLocale().toString(metres, 'f', 3) == data(index, Qt::DisplayRole).toString()) return true;
  const auto done = edits_.moveVertex(route_, n, place);
  if (!done) Q_EMIT refused(text(done.error().sentence));
  return done.has_value();
}

Qt::ItemFlags VertexModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags usual = QAbstractTableModel::flags(index);
  return index.column() == kLeg ? usual : usual | Qt::ItemIsEditable;
}

}  // namespace tessera::ui
