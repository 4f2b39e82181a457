#include "ui/zone/corner_model.h"

#include <QLocale>

#include "ui/base/tidy.h"
#include "ui/base/wording.h"

namespace tessera::ui {
namespace {

QString centimetres(Metres m) { return QLocale().toString(100.0 * m.value(), 'f', 1); }

}  // namespace

CornerModel::CornerModel(SiteDocument& document, QObject* parent) : QAbstractTableModel{parent}, edits_{document} {}

void CornerModel::setZone(const QString& zone) {
  zone_ = zone;
  const floor::Zone* found = edits_.find(zone_);
  const std::vector<Point> now = found != nullptr ? found->outline : std::vector<Point>{};
  if (now.size() != corners_.size()) {
    beginResetModel();
    corners_ = now;
    endResetModel();
  } else if (now != corners_) {
    corners_ = now;
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
  }
}

int CornerModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(corners_.size());
}

int CornerModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant CornerModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const auto n = static_cast<std::size_t>(index.row());
  if (role == Qt::TextAlignmentRole) return QVariant::fromValue<int>(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole && role != Qt::EditRole) return {};
  if (index.column() == kEdge) return centimetres(distance(corners_[n], corners_[(n + 1) % corners_.size()]));
  const Metres value = index.column() == kX ? corners_[n].x : corners_[n].y;
  if (role == Qt::EditRole) return 100.0 * value.value();
  return centimetres(value);
}

QVariant CornerModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Vertical) return role == Qt::DisplayRole ? QVariant{section + 1} : QVariant{};
  if (role == Qt::ToolTipRole) {
    if (section == kEdge) return tr("Length of the edge to the next corner");
    return tr("Place in the site, in centimetres");
  }
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case kX:
      return tr("x (cm)");
    case kY:
      return tr("y (cm)");
    default:
      return tr("Edge (cm)");
  }
}

bool CornerModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || !index.isValid() || index.row() >= rowCount() || index.column() == kEdge) return false;
  bool isNumber = false;
  const Metres metres{value.toDouble(&isNumber) / 100.0};
  if (!isNumber) return false;
  if (centimetres(metres) == data(index, Qt::DisplayRole).toString()) return true;
  const auto n = static_cast<std::size_t>(index.row());
  Point place = corners_[n];
  // What was not edited stays to the last digit.
  const Point edited = tidy({metres, metres});
  (index.column() == kX ? place.x : place.y) = edited.x;
  const auto done = edits_.moveCorner(zone_, n, place);
  if (!done) Q_EMIT refused(text(done.error().sentence));
  return done.has_value();
}

Qt::ItemFlags CornerModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags usual = QAbstractTableModel::flags(index);
  return index.column() == kEdge ? usual : usual | Qt::ItemIsEditable;
}

}  // namespace tessera::ui
