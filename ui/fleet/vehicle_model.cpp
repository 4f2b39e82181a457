#include "ui/fleet/vehicle_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/base/vehicle_colour.h"

namespace tessera::ui {
namespace {

using supervisor::VehicleView;

int rounded(double value) { return static_cast<int>(std::lround(std::min(value, 1e8))); }

}  // namespace

VehicleModel::VehicleModel(SiteDocument& document, QObject* parent) : QAbstractTableModel{parent}, document_{document} {
  connect(&document_, &SiteDocument::changed, this, &VehicleModel::takeSite);
  takeSite();
}

void VehicleModel::takeSite() {
  const auto& vehicles = document_.site().vehicles;
  const bool same = std::equal(rows_.begin(), rows_.end(), vehicles.begin(), vehicles.end(),
                               [](const Row& row, const auto& v) { return row.id == v.id; });
  if (same) {  // routes and zones are edited far more often than vehicles
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const QString name = QString::fromStdString(vehicles[i].name);
      if (rows_[i].name == name) continue;
      rows_[i].name = name;
      const QModelIndex cell = index(static_cast<int>(i), Name);
      Q_EMIT dataChanged(cell, cell);
    }
    return;
  }
  beginResetModel();
  rows_.clear();
  for (const auto& v : vehicles) {
    Row row;
    row.id = v.id;
    row.name = QString::fromStdString(v.name);
    rows_.push_back(rowFor(row, viewOf(v.id)));
  }
  endResetModel();
}

void VehicleModel::setSnapshot(std::shared_ptr<const supervisor::Snapshot> snapshot) {
  snapshot_ = std::move(snapshot);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const VehicleView* view = nullptr;
    if (snapshot_ && i < snapshot_->vehicles.size() && snapshot_->vehicles[i].id == rows_[i].id)
      view = &snapshot_->vehicles[i];  // both lists have the order of the site
    else
      view = viewOf(rows_[i].id);
    put(static_cast<int>(i), rowFor(rows_[i], view));
  }
}

const VehicleView* VehicleModel::viewOf(VehicleId id) const { return snapshot_ ? snapshot_->find(id) : nullptr; }

int VehicleModel::rowOf(VehicleId id) const {
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (rows_[i].id == id) return static_cast<int>(i);
  return -1;
}

VehicleModel::Row VehicleModel::rowFor(const Row& old, const VehicleView* view) const {
  Row row;
  row.id = old.id;
  row.name = old.name;
  row.condition = conditionOf(snapshot_.get(), view);
  if (view == nullptr) return row;
  row.route = view->route;
  if (!view->route.empty() && view->length > Metres{})
    row.permille = std::clamp(rounded(1000.0 * (view->progress / view->length)), 0, 1000);
  if (!view->link.lastHeard) return row;
  row.faults = view->faults;
  row.speed = rounded(100.0 * std::abs(view->speed.value()));
  row.battery = rounded(10.0 * view->batteryVolts);
  row.loss = rounded(100.0 * view->link.loss);
  row.age = rounded(10.0 * view->link.age.value());
  if (view->located) row.uncertainty = rounded(1000.0 * placeUncertainty(*view).value());
  return row;
}

void VehicleModel::put(int row, const Row& fresh) {
  Row& old = rows_[static_cast<std::size_t>(row)];
  const bool condition = old.condition != fresh.condition || old.faults != fresh.faults;
  const std::array<bool, ColumnCount> differs{false,
                                              condition,
                                              old.permille != fresh.permille,
                                              old.route != fresh.route,
                                              old.speed != fresh.speed,
                                              old.battery != fresh.battery || old.faults != fresh.faults,
                                              old.loss != fresh.loss,
                                              old.age != fresh.age,
                                              old.uncertainty != fresh.uncertainty};
  old = fresh;
  for (int column = 0; column < ColumnCount; ++column) {
    if (!differs[static_cast<std::size_t>(column)]) continue;
    const QModelIndex cell = index(row, column);
    Q_EMIT dataChanged(cell, cell);
  }
}

void VehicleModel::setPalette(const QPalette& palette) {
  palette_ = palette;
  refreshTexts();
}

void VehicleModel::refreshTexts() {
  Q_EMIT headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
  if (!rows_.empty()) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

int VehicleModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int VehicleModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

QVariant VehicleModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Row& row = rows_.at(static_cast<std::size_t>(index.row()));
  const int column = index.column();
  switch (role) {
    case Qt::DisplayRole:
    case Qt::AccessibleTextRole:
      return shown(row, column);
    case Qt::ToolTipRole:
      return tip(row, column);
    case SortRole:
      return sortKey(row, column);
    case VehicleRole:
      return static_cast<int>(row.id.value);
    case IconRole:
      return iconOf(row, column);
    case ToneRole:
      return static_cast<int>(toneFor(row, column));
    case DotRole:
      return column == Name ? QVariant{vehicleColour(index.row(), palette_)} : QVariant{};
    case PermilleRole:
      return column == Progress && row.permille != kUnknown ? QVariant{row.permille} : QVariant{};
    default:
      return {};
  }
}

}  // namespace tessera::ui
