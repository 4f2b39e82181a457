#include "ui/route/vertex_model.h"

#include <QLocale>
#include <cmath>

#include "ui/base/wording.h"

namespace tessera::ui {

VertexModel::VertexModel(SiteDocument& document, QObject* parent) : QAbstractTableModel{parent}, edits_{document} {}

void VertexModel::setRoute(const QString& route) {
  name_ = route;
  refresh();
}

void VertexModel::refresh() {
  const floor::Route* route = edits_.find(name_);
  const floor::Route now = route != nullptr ? *route : floor::Route{};
  if (now.vertices.size() != route_.vertices.size()) {
    beginResetModel();
    route_ = now;
    endResetModel();
  } else if (now != route_) {
    route_ = now;
    if (rowCount() > 0) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
  }
}

int VertexModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(route_.vertices.size());
}

int VertexModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant VertexModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const auto n = static_cast<std::size_t>(index.row());
  if (role == Qt::TextAlignmentRole) return QVariant::fromValue<int>(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole && role != Qt::EditRole) return {};
  const std::vector<Point>& all = route_.vertices;
  if (index.column() == kLeg) {
    if (n == 0) return {};
    return QLocale().toString(distance(all[n - 1], all[n]).value(), 'f', 3);
  }
  if (index.column() == kSpeed) {
    const auto speed = speedTo(n);
    if (!speed) return {};
    if (role == Qt::EditRole) return speed->value();
    return QLocale().toString(speed->value(), 'f', 3);
  }
  const double value = (index.column() == kX ? all[n].x : all[n].y).value();
  if (role == Qt::EditRole) return value;
  return QLocale().toString(value, 'f', 3);
}

QVariant VertexModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Vertical) return role == Qt::DisplayRole ? QVariant{section + 1} : QVariant{};
  if (role == Qt::ToolTipRole) {
    if (section == kLeg) return tr("Length of the leg from the vertex before");
    if (section == kSpeed) return tr("Highest speed on the leg from the vertex before; empty: as ordered");
    return tr("Place in the site, in metres");
  }
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case kX:
      return tr("x (m)");
    case kY:
      return tr("y (m)");
    case kLeg:
      return tr("Leg (m)");
    default:
      return tr("Max m/s");
  }
}

bool VertexModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || !index.isValid() || index.row() >= rowCount() || index.column() == kLeg) return false;
  if (index.column() == kSpeed) return setSpeed(static_cast<std::size_t>(index.row()), value);
  bool isNumber = false;
  const double metres = value.toDouble(&isNumber);
  if (!isNumber) return false;
  const auto n = static_cast<std::size_t>(index.row());
  Point place = route_.vertices[n];
  // What was not edited stays to the last digit.
  const Point edited = tidy({Metres{metres}, Metres{metres}});
  (index.column() == kX ? place.x : place.y) = edited.x;
  if (QLocale().toString(metres, 'f', 3) == data(index, Qt::DisplayRole).toString()) return true;
  const auto done = edits_.moveVertex(name_, n, place);
  if (!done) Q_EMIT refused(text(done.error().sentence));
  return done.has_value();
}

// An empty value takes the leg's speed away.
bool VertexModel::setSpeed(std::size_t vertex, const QVariant& value) {
  if (vertex == 0) return false;
  std::optional<MetresPerSecond> speed;
  if (value.isValid() && !value.toString().isEmpty()) {
    bool isNumber = false;
    speed = MetresPerSecond{value.toDouble(&isNumber)};
    if (!isNumber || !std::isfinite(speed->value()) || *speed <= MetresPerSecond{}) return false;
  }
  const auto before = speedTo(vertex);
  const auto shown = [](MetresPerSecond v) { return QLocale().toString(v.value(), 'f', 3); };
  if (speed == before || (speed && before && shown(*speed) == shown(*before))) return true;
  const auto done = edits_.setLegSpeed(name_, vertex - 1, speed);
  if (!done) Q_EMIT refused(text(done.error().sentence));
  return done.has_value();
}

std::optional<MetresPerSecond> VertexModel::speedTo(std::size_t vertex) const {
  return vertex == 0 ? std::nullopt : floor::legSpeed(route_, vertex - 1);
}

Qt::ItemFlags VertexModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags usual = QAbstractTableModel::flags(index);
  const bool fixed = index.column() == kLeg || (index.column() == kSpeed && index.row() == 0);
  return fixed ? usual : usual | Qt::ItemIsEditable;
}

}  // namespace tessera::ui
