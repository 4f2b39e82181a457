#include "ui/history/revision_model.h"

#include <QLocale>
#include <QStringList>
#include <algorithm>

namespace tessera::ui {

QString revisionTime(const QDateTime& when) {
  const QLocale locale;
  return locale.toString(when.date(), QLocale::ShortFormat) + QLatin1Char{' '} +
         when.time().toString(QStringLiteral("HH:mm:ss"));
}

QString tallyText(const sitediff::Tally& tally) {
  QStringList parts;
  const auto add = [&parts](int count, const QString& text) {
    if (count > 0) parts << text;
  };
  add(tally.laid, RevisionModel::tr("%n tile(s) laid", nullptr, tally.laid));
  add(tally.moved, RevisionModel::tr("%n tile(s) moved", nullptr, tally.moved));
  add(tally.takenUp, RevisionModel::tr("%n tile(s) taken up", nullptr, tally.takenUp));
  add(tally.tags, RevisionModel::tr("%n tag(s)", nullptr, tally.tags));
  add(tally.zones, RevisionModel::tr("%n zone(s)", nullptr, tally.zones));
  add(tally.routes, RevisionModel::tr("%n route(s)", nullptr, tally.routes));
  add(tally.vehicles, RevisionModel::tr("%n vehicle(s)", nullptr, tally.vehicles));
  add(tally.others, RevisionModel::tr("%n other change(s)", nullptr, tally.others));
  return parts.isEmpty() ? RevisionModel::tr("only the order of lists") : parts.join(QStringLiteral(", "));
}

void RevisionModel::setLines(std::vector<RevisionLine> lines) {
  beginResetModel();
  lines_ = std::move(lines);
  endResetModel();
}

int RevisionModel::rowOf(qint64 id) const {
  const auto found = std::find_if(lines_.begin(), lines_.end(), [id](const RevisionLine& l) { return l.id == id; });
  return found == lines_.end() ? -1 : static_cast<int>(found - lines_.begin());
}

void RevisionModel::retranslate() {
  Q_EMIT headerDataChanged(Qt::Horizontal, 0, kColumns - 1);
  if (!lines_.empty()) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
}

int RevisionModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(lines_.size());
}

int RevisionModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QString RevisionModel::cell(const RevisionLine& line, int column) const {
  switch (column) {
    case kWhen:
      return revisionTime(line.when);
    case kWho:
      return line.who.isEmpty() ? tr("unknown") : line.who;
    case kWhat:
      if (line.found) return tr("the file as it was opened");
      return line.what.isEmpty() ? tr("saved without a step") : line.what;
    default:
      if (line.changed) return tallyText(*line.changed);
      return line.id == lines_.back().id ? tr("the first that is kept") : tr("not known");
  }
}

QVariant RevisionModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const RevisionLine& l = line(index.row());
  if (role == Qt::DisplayRole) return cell(l, index.column());
  if (role == Qt::ToolTipRole)
    return tr("%1, %2\n%3\n%4")
        .arg(QLocale{}.toString(l.when, QLocale::LongFormat), cell(l, kWho), cell(l, kWhat), cell(l, kChanged));
  return {};
}

QVariant RevisionModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case kWhen:
      return tr("When");
    case kWho:
      return tr("Who");
    case kWhat:
      return tr("What");
    default:
      return tr("Changes");
  }
}

}  // namespace tessera::ui
