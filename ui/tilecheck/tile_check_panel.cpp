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
  if (watch_.progress().tiles == 0) return tr("No tiles are laid: there is nothing to check.");
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
  const int row = list_->currentRow();
  const auto chosen = row >= 0 && row < static_cast<int>(listed_.size())
                          ? listed_[static_cast<std::size_t>(row)].serials
                          : std::vector<std::string>{};
  listed_ = watch_.suspects();
  const QSignalBlocker quiet{list_};
  while (list_->count() > static_cast<int>(listed_.size())) delete list_->takeItem(list_->count() - 1);
  int now = -1;
  for (int n = 0; n < static_cast<int>(listed_.size()); ++n) {
    if (n == list_->count()) list_->addItem(new QListWidgetItem{icon("warning"), {}});
    list_->item(n)->setText(text(listed_[static_cast<std::size_t>(n)].sentence));
    if (listed_[static_cast<std::size_t>(n)].serials == chosen) now = n;
  }
  list_->setCurrentRow(now);
  pages_->setCurrentIndex(listed_.empty() ? 0 : 1);
  empty_->setText(whatNow());
  refreshButtons();
}

void TileCheckPanel::refreshButtons() {
  const bool chosen = list_->currentRow() >= 0;
  show_->setEnabled(chosen);
  mend_->setEnabled(chosen);
  reset_->setEnabled(watch_.progress().untouched() < watch_.progress().tiles);
}

void TileCheckPanel::goTo(int row) {
  if (row < 0 || row >= static_cast<int>(listed_.size())) return;
  if (const SiteBox place = watch_.placeOf(listed_[static_cast<std::size_t>(row)]); !place.empty())
    Q_EMIT placeWanted(place);
}

void TileCheckPanel::mend() {
  const int row = list_->currentRow();
  if (row < 0 || row >= static_cast<int>(listed_.size())) return;
  const tilecheck::TileSuspect suspect = listed_[static_cast<std::size_t>(row)];
  if (const auto done = watch_.mend(suspect); !done) Q_EMIT refused(text(done.error().sentence));
}

void TileCheckPanel::retranslate() {
  setWindowTitle(tr("Drive-over check"));
  reset_->setText(tr("Begin anew"));
  reset_->setToolTip(tr("Forget what was read so far"));
  show_->setText(tr("Show"));
  show_->setToolTip(tr("Show the tiles on the floor (Enter)"));
  mend_->setText(tr("Correct the site"));
  mend_->setToolTip(tr("The site gets these tiles as they lie on the floor; it can be undone"));
  list_->setAccessibleName(tr("Tiles that lie otherwise than the site says"));
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
