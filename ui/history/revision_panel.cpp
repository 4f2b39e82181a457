#include "ui/history/revision_panel.h"

#include <QAction>
#include <QItemSelectionModel>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPixmap>
#include <QScrollBar>
#include <QSplitter>
#include <QStackedWidget>
#include <QTreeView>
#include <algorithm>
#include <utility>

#include "ui/base/wording.h"

namespace tessera::ui {
namespace {

// Nobody reads more; the floor shows all of them.
constexpr std::size_t kMostListed = 5000;

QIcon signOf(ChangeLook look, const QPalette& palette, int side, double ratio) {
  QPixmap picture{QSize{side, side} * ratio};
  picture.setDevicePixelRatio(ratio);
  picture.fill(Qt::transparent);
  QPainter painter{&picture};
  painter.setRenderHint(QPainter::Antialiasing);
  paintChangeSign(painter, CanvasTheme{palette}, look, {side / 2.0, side / 2.0}, 0.36 * side);
  return QIcon{picture};
}

}  // namespace

void RevisionPanel::setRevisions(std::vector<RevisionLine> lines) {
  filling_ = true;
  model_->setLines(std::move(lines));
  const int row = chosen_ ? model_->rowOf(chosen_->id) : -1;
  if (row >= 0) table_->setCurrentIndex(model_->index(row, 0));
  filling_ = false;
  // It is another site's, or was thinned out.
  if (chosen_ && row < 0) leave();
  refresh();
}

void RevisionPanel::setRevision(qint64 id, std::shared_ptr<const floor::SiteMap> map) {
  if (!chosen_ || chosen_->id != id) return;
  revision_ = std::move(map);
  compareAgain();
}

void RevisionPanel::setRevisionTrouble(qint64 id, const QString& sentence) {
  if (!chosen_ || chosen_->id != id) return;
  trouble_ = sentence;
  refresh();
}

void RevisionPanel::setAuthor(const QString& name, const QString& proposed) {
  author_->setText(name);
  author_->setPlaceholderText(proposed);
}

void RevisionPanel::choose() {
  const QModelIndex current = table_->currentIndex();
  if (!current.isValid()) return;
  chosen_ = model_->line(current.row());
  revision_.reset();
  comparison_.reset();
  comparer_->drop();
  trouble_.clear();
  fillList();
  refresh();
  Q_EMIT changed();
  Q_EMIT revisionWanted(chosen_->id);
}

void RevisionPanel::leave() {
  chosen_.reset();
  revision_.reset();
  comparison_.reset();
  comparer_->drop();
  trouble_.clear();
  filling_ = true;
  table_->setCurrentIndex({});
  table_->clearSelection();
  filling_ = false;
  fillList();
  refresh();
  Q_EMIT changed();
}

void RevisionPanel::compareAgain() {
  if (!revision_) return refresh();
  comparer_->compare(revision_, document_.map());
  refresh();
}

void RevisionPanel::takeUp(const std::shared_ptr<const Comparison>& comparison) {
  comparison_ = comparison;
  fillList();
  refresh();
  Q_EMIT changed();
}

void RevisionPanel::fillList() {
  filling_ = true;
  const int row = list_->currentRow();
  const int scrolled = list_->verticalScrollBar()->value();
  list_->clear();
  const auto& all = comparison_ ? comparison_->changes : sitediff::Changes{};
  const int side = fontMetrics().height();
  std::array<QIcon, 4> signs;
  for (std::size_t n = 0; n < signs.size(); ++n)
    signs.at(n) = signOf(static_cast<ChangeLook>(n), palette(), side, devicePixelRatioF());
  for (std::size_t n = 0; n < std::min(all.size(), kMostListed); ++n) {
    const ChangeLook look = comparison_->marks.signs[n].look;
    auto* item = new QListWidgetItem{signs.at(static_cast<std::size_t>(look)), text(all[n].sentence)};
    item->setData(Qt::AccessibleTextRole, changeLookText(look) + QStringLiteral(": ") + item->text());
    list_->addItem(item);
  }
  if (all.size() > kMostListed) {
    auto* more = new QListWidgetItem{tr("and %n more", nullptr, static_cast<int>(all.size() - kMostListed))};
    more->setFlags(Qt::NoItemFlags);
    list_->addItem(more);
  }
  if (row >= 0 && row < list_->count()) list_->setCurrentRow(row);
  list_->verticalScrollBar()->setValue(scrolled);
  filling_ = false;
}

void RevisionPanel::refresh() {
  const bool any = model_->rowCount() > 0;
  pages_->setCurrentWidget(any ? static_cast<QWidget*>(split_) : empty_);
  empty_->setText(document_.path().isEmpty()
                      ? tr("This site is in no file yet. Save it (Ctrl+S): each saving becomes a revision here.")
                      : tr("There is no revision yet. Save the site (Ctrl+S): each saving becomes a revision here."));
  const auto when = chosen_ ? revisionTime(chosen_->when) : QString{};
  if (!chosen_)
    head_->setText(tr("Choose a revision to see what has changed since then."));
  else if (!trouble_.isEmpty())
    head_->setText(trouble_);
  else if (!revision_ || !comparison_)
    head_->setText(tr("Comparing…"));
  else if (comparison_->changes.empty())
    head_->setText(tr("The site is the same as on %1.").arg(when));
  else
    head_->setText(
        tr("Since %1: %n difference(s). Click one to go there.", nullptr, static_cast<int>(comparison_->changes.size()))
            .arg(when));
  back_->setEnabled(revision_ != nullptr);
  export_->setEnabled(revision_ != nullptr);
  leave_->setEnabled(chosen_.has_value());
}

ChangeMarks RevisionPanel::marks() const {
  if (!comparison_) return {};
  ChangeMarks marks = comparison_->marks;
  marks.title = tr("Since %1").arg(revisionTime(chosen_->when));
  const std::size_t listed = std::min(marks.signs.size(), kMostListed);
  for (std::size_t n = 0; n < listed; ++n) marks.signs[n].sentence = text(comparison_->changes[n].sentence);
  if (list_->currentRow() >= 0 && static_cast<std::size_t>(list_->currentRow()) < listed)
    marks.chosen = static_cast<std::size_t>(list_->currentRow());
  return marks;
}

void RevisionPanel::goTo(int row) {
  if (!comparison_ || row < 0 || static_cast<std::size_t>(row) >= comparison_->changes.size()) return;
  if (const SiteBox& place = comparison_->marks.signs[static_cast<std::size_t>(row)].place; !place.empty())
    Q_EMIT placeWanted(place);
}

void RevisionPanel::goBack() {
  if (!revision_) return;
  floor::Site site = revision_->site();
  // A vehicle obeys nobody but who has its present key: an older one would take it away.
  bool keys = false;
  for (floor::VehicleSetup& vehicle : site.vehicles) {
    const floor::VehicleSetup* now = document_.map()->vehicle(vehicle.id);
    if (now == nullptr || now->key == vehicle.key) continue;
    vehicle.key = now->key;
    keys = true;
  }
  if (site == document_.site()) {
    Q_EMIT told(tr("The site is as it was then: there is nothing to go back to."));
    return;
  }
  const QString when = revisionTime(chosen_->when);
  const auto done =
      document_.edit(tr("Go back to %1").arg(when), [&](floor::Site& present) { present = std::move(site); });
  if (!done) {
    Q_EMIT told(text(done.error().sentence));
    return;
  }
  const QString sentence = tr("The site is as it was on %1. Undo (Ctrl+Z) takes that back.").arg(when);
  Q_EMIT told(keys ? sentence + QLatin1Char{' '} + tr("The vehicles keep the keys that they have now.") : sentence);
}

}  // namespace tessera::ui
