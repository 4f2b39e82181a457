#include "ui/site/loose_tag_model.h"

#include <QLocale>
#include <cmath>

#include "ui/base/wording.h"

namespace tessera::ui {

LooseTagModel::LooseTagModel(std::vector<floor::LooseTag> tags, QObject* parent)
    : QAbstractTableModel{parent}, tags_{std::move(tags)} {}

int LooseTagModel::add() {
  const int row = rowCount();
  beginInsertRows({}, row, row);
  tags_.push_back({{}, tags_.empty() ? Point{} : tags_.back().place});
  endInsertRows();
  Q_EMIT edited();
  return row;
}

void LooseTagModel::remove(int row) {
  if (row < 0 || row >= rowCount()) return;
  beginRemoveRows({}, row, row);
  tags_.erase(tags_.begin() + row);
  endRemoveRows();
  Q_EMIT edited();
}

void LooseTagModel::retranslate() { Q_EMIT headerDataChanged(Qt::Horizontal, 0, Columns - 1); }

int LooseTagModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(tags_.size());
}

int LooseTagModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : Columns; }

QVariant LooseTagModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role != Qt::DisplayRole) return {};
  if (orientation == Qt::Vertical) return section + 1;
  switch (section) {
    case Uid:
      return tr("UID");
    case X:
      return tr("x (m)");
    default:
      return tr("y (m)");
  }
}

QVariant LooseTagModel::data(const QModelIndex& index, int role) const {
  const floor::LooseTag& tag = tags_[static_cast<std::size_t>(index.row())];
  if (index.column() == Uid) {
    if (role == Qt::DisplayRole && tag.uid.empty()) return tr("not registered");
    if (role == Qt::DisplayRole || role == Qt::EditRole) return QString::fromStdString(tag.uid.text());
    return {};
  }
  const double metres = (index.column() == X ? tag.place.x : tag.place.y).value();
  if (role == Qt::DisplayRole) return QLocale{}.toString(metres, 'f', 3);
  if (role == Qt::EditRole) return metres;
  if (role == Qt::TextAlignmentRole) return QVariant{Qt::AlignRight | Qt::AlignVCenter};
  return {};
}

Qt::ItemFlags LooseTagModel::flags(const QModelIndex& index) const {
  return QAbstractTableModel::flags(index) | Qt::ItemIsEditable;
}

bool LooseTagModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || !index.isValid()) return false;
  floor::LooseTag& tag = tags_[static_cast<std::size_t>(index.row())];
  if (index.column() == Uid) {
    const std::string typed = value.toString().trimmed().toStdString();
    floor::TagUid uid;
    if (!typed.empty()) {
      const auto parsed = floor::TagUid::parse(typed);
      if (!parsed) {
        Q_EMIT refused(text(parsed.error().sentence));
        return false;
      }
      uid = *parsed;
    }
    if (tag.uid == uid) return true;
    tag.uid = uid;
  } else {
    bool isNumber = false;
    const double metres = value.toDouble(&isNumber);
    if (!isNumber || !(std::abs(metres) <= kFarthest)) return false;
    Metres& coordinate = index.column() == X ? tag.place.x : tag.place.y;
    if (coordinate == Metres{metres}) return true;
    coordinate = Metres{metres};
  }
  Q_EMIT dataChanged(index, index);
  Q_EMIT edited();
  return true;
}

}  // namespace tessera::ui
