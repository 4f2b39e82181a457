#include "ui/tilecheck/tile_check_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/base/icon.h"
#include "ui/base/wording.h"

namespace tessera::ui {

TileCheckPanel::TileCheckPanel(TileWatch& watch, FleetLink& fleet, QWidget* parent)
    : QWidget{parent}, watch_{watch}, fleet_{fleet} {
  setObjectName("tileCheckPanel");
  const auto button = [](const char* name, const char* picture) {
    auto* made = new QPushButton{icon(picture), {}};
    made->setObjectName(name);
    return made;
  };
  run_ = button("runTileCheck", "run");
  reset_ = button("resetTileCheck", "clear");
  show_ = button("showSuspect", "place");
  mend_ = button("mendSuspect", "wizard");
  bar_ = new QProgressBar;
  bar_->setObjectName("tileCheckBar");
  counts_ = new QLabel;
  counts_->setObjectName("tileCheckCounts");
  counts_->setWordWrap(true);
  empty_ = new QLabel;
  empty_->setObjectName("tileCheckHint");
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  list_ = new QListWidget;
  list_->setObjectName("suspectList");
  list_->setWordWrap(true);
  pages_ = new QStackedWidget;
  pages_->addWidget(empty_);
  pages_->addWidget(list_);
  auto* upper = new QHBoxLayout;
  upper->addWidget(run_);
  upper->addWidget(reset_);
  auto* lower = new QHBoxLayout;
  lower->addWidget(show_);
  lower->addWidget(mend_);
  auto* layout = new QVBoxLayout{this};
  layout->addLayout(upper);
  layout->addWidget(bar_);
  layout->addWidget(counts_);
  layout->addWidget(pages_, 1);
  layout->addLayout(lower);
  connect(run_, &QPushButton::clicked, this, [this] { watch_.setRunning(!watch_.isRunning()); });
  connect(reset_, &QPushButton::clicked, &watch_, &TileWatch::reset);
  connect(show_, &QPushButton::clicked, this, [this] { goTo(list_->currentRow()); });
  connect(mend_, &QPushButton::clicked, this, &TileCheckPanel::mend);
  connect(list_, &QListWidget::currentRowChanged, this, &TileCheckPanel::refreshButtons);
  connect(list_, &QListWidget::itemClicked, this, [this] { goTo(list_->currentRow()); });
  connect(list_, &QListWidget::itemActivated, this, [this] { goTo(list_->currentRow()); });
  connect(&watch_, &TileWatch::changed, this, &TileCheckPanel::refresh);
  connect(&fleet_, &FleetLink::snapshotChanged, this, [this] {
    if ((fleet_.latest() != nullptr) != live_) refresh();
  });
  retranslate();
  refresh();
}

QString TileCheckPanel::whatNow() const {
  if (watch_.progress().tiles == 0)
    return tr(
        "No tiles are laid yet. Lay them with Lay tiles in the tool bar, and register their tags; a drive over them "
        "then "
        "checks both.");
  const bool some = watch_.progress().untouched() < watch_.progress().tiles;
  if (!watch_.isRunning() && !some)
    return tr(
        "Press Start, then drive a vehicle along the rows of tiles. Each tag that it reads tells whether its tile "
        "lies where the site says.");
  if (watch_.isRunning() && !live_) return tr("Connect to the vehicles: none is supervised yet.");
  if (!some) return tr("Drive a vehicle along the rows of tiles.");
  if (watch_.progress().confirmed == watch_.progress().tiles) return tr("Every tile lies where the site says.");
  return watch_.isRunning() ? tr("So far every tile lies where the site says. Drive on along the rows.")
                            : tr("So far every tile lies where the site says.");
}

void TileCheckPanel::refresh() {
  live_ = fleet_.latest() != nullptr;
  const TileWatch::Progress& progress = watch_.progress();
  run_->setText(watch_.isRunning() ? tr("Pause") : tr("Start"));
  run_->setIcon(icon(watch_.isRunning() ? "pause" : "run"));
  run_->setEnabled(progress.tiles > 0);
  bar_->setRange(0, std::max(1, progress.tiles));
  bar_->setValue(progress.confirmed + progress.suspect);
  counts_->setText(tr("Confirmed: %1 of %2. Seen: %3. Lies otherwise: %4. Not yet driven over: %5.")
                       .arg(progress.confirmed)
                       .arg(progress.tiles)
                       .arg(progress.seen)
                       .arg(progress.suspect)
                       .arg(progress.untouched()));
  // Who has chosen one keeps it while others are found.
  const Found* before = foundAt(list_->currentRow());
  const std::string chosen = before != nullptr ? subjectOf(*before) : std::string{};
  listed_.clear();
  for (const auto& suspect : watch_.suspects()) listed_.emplace_back(suspect);
  for (const auto& finding : watch_.findings()) listed_.emplace_back(finding);
  const QSignalBlocker quiet{list_};
  while (list_->count() > static_cast<int>(listed_.size())) delete list_->takeItem(list_->count() - 1);
  int now = -1;
  for (int n = 0; n < static_cast<int>(listed_.size()); ++n) {
    if (n == list_->count()) list_->addItem(new QListWidgetItem{icon("warning"), {}});
    const Found& found = *foundAt(n);
    list_->item(n)->setText(text(sentenceOf(found)));
    if (subjectOf(found) == chosen) now = n;
  }
  list_->setCurrentRow(now);
  pages_->setCurrentIndex(listed_.empty() ? 0 : 1);
  empty_->setText(whatNow());
  refreshButtons();
}

void TileCheckPanel::refreshButtons() {
  const Found* found = foundAt(list_->currentRow());
  const auto* finding = found != nullptr ? std::get_if<tilecheck::TagFinding>(found) : nullptr;
  show_->setEnabled(found != nullptr);
  mend_->setEnabled(found != nullptr && (finding == nullptr || finding->fix));
  mend_->setToolTip(finding == nullptr ? tr("The site gets these tiles as they lie on the floor; it can be undone")
                    : finding->fix     ? tr("The tag that was read is registered there; it can be undone")
                                       : tr("Have a look at the place: no edit of the site mends this."));
  reset_->setEnabled(watch_.progress().untouched() < watch_.progress().tiles);
}

void TileCheckPanel::goTo(int row) {
  const Found* found = foundAt(row);
  if (found == nullptr) return;
  SiteBox place;
  if (const auto* finding = std::get_if<tilecheck::TagFinding>(found)) {
    constexpr Metres around{0.1};
    place.add(finding->place + Offset{-around, -around});
    place.add(finding->place + Offset{around, around});
  } else {
    place = watch_.placeOf(std::get<tilecheck::TileSuspect>(*found));
  }
  if (!place.empty()) Q_EMIT placeWanted(place);
}

const Sentence& TileCheckPanel::sentenceOf(const Found& found) {
  return std::visit([](const auto& one) -> const Sentence& { return one.sentence; }, found);
}

std::string TileCheckPanel::subjectOf(const Found& found) {
  if (const auto* finding = std::get_if<tilecheck::TagFinding>(&found)) return "tag " + finding->subject;
  std::string all;
  for (const std::string& serial : std::get<tilecheck::TileSuspect>(found).serials) all += serial + '\n';
  return all;
}

const TileCheckPanel::Found* TileCheckPanel::foundAt(int row) const {
  return row < 0 || row >= static_cast<int>(listed_.size()) ? nullptr : &listed_[static_cast<std::size_t>(row)];
}

void TileCheckPanel::mend() {
  if (!mend_->isEnabled() || foundAt(list_->currentRow()) == nullptr) return;
  const Found found = *foundAt(list_->currentRow());  // the list is another as soon as it is done
  const auto done = std::visit([this](const auto& one) { return watch_.mend(one); }, found);
  if (!done) Q_EMIT refused(text(done.error().sentence));
}

void TileCheckPanel::retranslate() {
  setWindowTitle(tr("Drive-over check"));
  reset_->setText(tr("Begin anew"));
  reset_->setToolTip(tr("Forget what was read so far"));
  show_->setText(tr("Show"));
  show_->setToolTip(tr("Show the place on the floor (Enter)"));
  mend_->setText(tr("Correct the site"));
  list_->setAccessibleName(tr("Tiles and tags that are otherwise than the site says"));
  bar_->setAccessibleName(tr("Checked tiles"));
}

void TileCheckPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange) {
    retranslate();
    refresh();
  }
  QWidget::changeEvent(event);
}

}  // namespace tessera::ui
