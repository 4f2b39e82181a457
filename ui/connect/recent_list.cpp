#include "ui/connect/recent_list.h"

#include <QDir>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLocale>
#include <QShortcut>
#include <QVBoxLayout>
#include <utility>

namespace tessera::ui {
namespace {
enum RecentColumn { kName, kPath, kOpened, kRecentColumns };
}

RecentList::RecentList(QWidget* parent) : QWidget{parent} {
  QFont bold = font();
  bold.setBold(true);
  heading_.setFont(bold);
  heading_.setBuddy(&list_);
  heading_.setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);  // what stands below it keeps close to it
  empty_.setAlignment(Qt::AlignTop | Qt::AlignLeft);
  empty_.setWordWrap(true);
  empty_.setForegroundRole(QPalette::PlaceholderText);
  list_.setObjectName(QStringLiteral("recentList"));
  list_.setColumnCount(kRecentColumns);
  list_.setRootIsDecorated(false);
  list_.setUniformRowHeights(true);
  list_.setAllColumnsShowFocus(true);
  list_.setTextElideMode(Qt::ElideMiddle);
  list_.setMinimumHeight(fontMetrics().height() * 6);
  open_.setObjectName(QStringLiteral("openRecent"));
  forget_.setObjectName(QStringLiteral("forgetRecent"));
  open_.setAutoDefault(false);
  forget_.setAutoDefault(false);

  auto* buttons = new QHBoxLayout;
  buttons->addStretch();
  buttons->addWidget(&forget_);
  buttons->addWidget(&open_);
  auto* column = new QVBoxLayout{this};
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(&heading_);
  column->addWidget(&empty_);
  column->addWidget(&list_, 1);
  column->addLayout(buttons);

  auto* remove = new QShortcut{QKeySequence::Delete, &list_, nullptr, nullptr, Qt::WidgetShortcut};
  connect(remove, &QShortcut::activated, this, &RecentList::forgetCurrent);
  connect(&list_, &QTreeWidget::itemActivated, this, [this] { openCurrent(); });
  connect(&list_, &QTreeWidget::currentItemChanged, this, [this] { showCurrent(); });
  connect(&open_, &QPushButton::clicked, this, &RecentList::openCurrent);
  connect(&forget_, &QPushButton::clicked, this, &RecentList::forgetCurrent);
  retranslate();
}

void RecentList::setSites(std::vector<RecentSite> sites) {
  sites_ = std::move(sites);
  fill();
}

void RecentList::fill() {
  const int row = list_.indexOfTopLevelItem(list_.currentItem());
  list_.clear();
  for (const RecentSite& site : sites_) {
    auto* item = new QTreeWidgetItem{&list_};
    item->setText(kName, site.name.isEmpty() ? tr("Unnamed site") : site.name);
    item->setText(kPath, QDir::toNativeSeparators(site.path));
    item->setText(kOpened, QLocale{}.toString(site.opened.toLocalTime(), QLocale::ShortFormat));
    for (int column = 0; column < kRecentColumns; ++column) {
      item->setToolTip(column, site.missing ? tr("%1 is no longer there.").arg(QDir::toNativeSeparators(site.path))
                                            : QDir::toNativeSeparators(site.path));
      if (site.missing) item->setForeground(column, palette().brush(QPalette::PlaceholderText));
    }
    if (site.missing) item->setText(kOpened, tr("not found"));
  }
  const bool any = !sites_.empty();
  if (any) list_.setCurrentItem(list_.topLevelItem(std::clamp(row, 0, list_.topLevelItemCount() - 1)));
  list_.header()->setStretchLastSection(false);
  list_.header()->setSectionResizeMode(kPath, QHeaderView::Stretch);
  list_.resizeColumnToContents(kName);
  list_.resizeColumnToContents(kOpened);
  list_.setVisible(any);
  open_.setVisible(any);
  forget_.setVisible(any);
  empty_.setVisible(!any);
  showCurrent();
}

const RecentSite* RecentList::current() const {
  const int row = list_.indexOfTopLevelItem(list_.currentItem());
  return row < 0 || row >= static_cast<int>(sites_.size()) ? nullptr : &sites_[static_cast<std::size_t>(row)];
}

void RecentList::showCurrent() {
  const RecentSite* site = current();
  open_.setEnabled(site != nullptr && !site->missing);
  forget_.setEnabled(site != nullptr);
}

void RecentList::openCurrent() {
  if (const RecentSite* site = current(); site != nullptr && !site->missing) Q_EMIT chosen(QString{site->path});
}

// A copy, as the answer to the signal is a new list.
void RecentList::forgetCurrent() {
  if (const RecentSite* site = current()) Q_EMIT forgotten(QString{site->path});
}

void RecentList::retranslate() {
  heading_.setText(tr("&Recent sites"));
  empty_.setText(tr("Sites that you open will be listed here."));
  list_.setAccessibleName(tr("Recent sites"));
  list_.setHeaderLabels({tr("Site"), tr("File"), tr("Last opened")});
  open_.setText(tr("Open t&his site"));
  forget_.setText(tr("Remove &from list"));
  forget_.setToolTip(tr("Takes the entry off this list (Del). The file stays."));
  fill();
}

void RecentList::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  if (event->type() == QEvent::PaletteChange) fill();
  QWidget::changeEvent(event);
}

}  // namespace tessera::ui
