#include "ui/fleet/event_model.h"

#include <QLocale>
#include <algorithm>

#include "supervisor/parameter_texts.h"
#include "ui/fleet/tone.h"

namespace tessera::ui {

using supervisor::Severity;

EventModel::EventModel(SiteDocument& document, QObject* parent) : QAbstractTableModel{parent}, document_{document} {}

// The oldest go in lots: a list that loses its first row with each new one would be laid out anew each time.
void EventModel::trim(std::size_t coming) {
  if (lines_.size() + coming <= kMost) return;
  const std::size_t drop = std::min(lines_.size(), lines_.size() + coming - kMost + kMost / 10);
  if (drop == 0) return;
  beginRemoveRows({}, 0, static_cast<int>(drop) - 1);
  lines_.erase(lines_.begin(), lines_.begin() + static_cast<std::ptrdiff_t>(drop));
  endRemoveRows();
}

void EventModel::append(const std::vector<supervisor::Event>& events) {
  std::vector<JournalLine> lines;
  for (const supervisor::Event& event : events)
    if (!supervisor::isSample(event))
      lines.push_back(
          {clock_ ? clock_(event.time) : QDateTime::currentDateTime(), event.severity, event.vehicle, event.sentence});
  const std::size_t take = std::min(lines.size(), kMost);
  if (take == 0) return;
  trim(take);
  const int first = rowCount();
  beginInsertRows({}, first, first + static_cast<int>(take) - 1);
  lines_.insert(lines_.end(), lines.end() - static_cast<std::ptrdiff_t>(take), lines.end());
  endInsertRows();
}

void EventModel::prepend(const std::vector<JournalLine>& lines) {
  const std::size_t take = std::min(lines.size(), kMost - std::min(kMost, lines_.size()));
  if (take == 0) return;
  beginInsertRows({}, 0, static_cast<int>(take) - 1);
  for (std::size_t i = 0; i < take; ++i) {
    lines_.push_front(lines[lines.size() - 1 - i]);
  }
  endInsertRows();
}

void EventModel::clear() {
  beginResetModel();
  lines_.clear();
  endResetModel();
}

void EventModel::refreshTexts() {
  Q_EMIT headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
  if (!lines_.empty()) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

int EventModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(lines_.size());
}

int EventModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

QString EventModel::nameOf(const std::optional<VehicleId>& vehicle) const {
  if (!vehicle) return {};
  const floor::VehicleSetup* known = document_.map()->vehicle(*vehicle);
  return known == nullptr ? tr("Vehicle %1").arg(vehicle->value) : QString::fromStdString(known->name);
}

QString EventModel::shown(const JournalLine& line, int column) const {
  const QLocale locale;
  switch (column) {
    case When: {
      const QString time = locale.toString(line.when.time(), QStringLiteral("HH:mm:ss"));
      if (line.when.date() == QDate::currentDate()) return time;
      return tr("%1 %2", "date, time of day").arg(locale.toString(line.when.date(), QLocale::ShortFormat), time);
    }
    case Who:
      return nameOf(line.vehicle);
    case What:
      if (const auto* live = std::get_if<Sentence>(&line.sentence)) return text(*live);
      return std::get<QString>(line.sentence);
    default:
      return {};
  }
}

QVariant EventModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const JournalLine& line = lines_.at(static_cast<std::size_t>(index.row()));
  const int column = index.column();
  switch (role) {
    case Qt::DisplayRole:
      return shown(line, column);
    case Qt::ToolTipRole:
      return column == When ? QLocale{}.toString(line.when, QLocale::LongFormat) : shown(line, What);
    case VehicleRole:
      return line.vehicle ? QVariant{static_cast<int>(line.vehicle->value)} : QVariant{};
    case SeverityRole:
      return static_cast<int>(line.severity);
    case TimeRole:
      return line.when;
    case IconRole:
      if (column != What) return {};
      if (line.severity == Severity::Info) return QStringLiteral("info");
      return line.severity == Severity::Warning ? QStringLiteral("warning") : QStringLiteral("error");
    case ToneRole:
      if (column != What) return static_cast<int>(column == When ? Tone::Quiet : Tone::Plain);
      if (line.severity == Severity::Info) return static_cast<int>(Tone::Plain);
      return static_cast<int>(line.severity == Severity::Warning ? Tone::Warning : Tone::Bad);
    default:
      return {};
  }
}

QVariant EventModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  if (section == When) return tr("Time");
  return section == Who ? tr("Vehicle") : tr("What happened");
}

void EventFilter::set(Severity least, std::optional<VehicleId> vehicle, const QString& words) {
  least_ = least;
  vehicle_ = vehicle;
  words_ = words.trimmed();
  invalidateFilter();
}

bool EventFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
  const auto* model = sourceModel();
  const QModelIndex what = model->index(row, EventModel::What, parent);
  if (what.data(SeverityRole).toInt() < static_cast<int>(least_)) return false;
  if (vehicle_) {
    const QVariant who = what.data(VehicleRole);
    if (!who.isValid() || who.toInt() != static_cast<int>(vehicle_->value)) return false;
  }
  if (words_.isEmpty()) return true;
  const auto holds = [&](int column) {
    return model->index(row, column, parent).data().toString().contains(words_, Qt::CaseInsensitive);
  };
  return holds(EventModel::What) || holds(EventModel::Who);
}

}  // namespace tessera::ui
