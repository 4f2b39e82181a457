// How the panel of revisions is laid out, and its words.
#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QSplitter>
#include <QStackedWidget>
#include <QToolBar>
#include <QTreeView>
#include <QVBoxLayout>

#include "ui/base/icon.h"
#include "ui/history/revision_panel.h"

namespace tessera::ui {

RevisionPanel::RevisionPanel(SiteDocument& document, QWidget* parent)
    : QWidget{parent}, document_{document}, model_{new RevisionModel{this}}, comparer_{new Comparer{this}} {
  setObjectName(QStringLiteral("revisionPanel"));
  const int line = fontMetrics().height();
  table_ = new QTreeView;
  table_->setObjectName(QStringLiteral("revisionTable"));
  table_->setModel(model_);
  table_->setRootIsDecorated(false);
  table_->setUniformRowHeights(true);
  table_->setAllColumnsShowFocus(true);
  table_->setAlternatingRowColors(true);
  table_->header()->resizeSection(RevisionModel::kWhen, 11 * line);
  table_->header()->resizeSection(RevisionModel::kWho, 6 * line);
  table_->header()->resizeSection(RevisionModel::kWhat, 14 * line);
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this] {
    if (!filling_) choose();
  });
  split_ = new QSplitter{Qt::Horizontal};
  split_->addWidget(table_);
  split_->addWidget(makeDifferences());
  split_->setStretchFactor(0, 3);
  split_->setStretchFactor(1, 2);
  split_->setChildrenCollapsible(false);
  empty_ = new QLabel;
  empty_->setObjectName(QStringLiteral("noRevisions"));
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  pages_ = new QStackedWidget;
  pages_->addWidget(empty_);
  pages_->addWidget(split_);
  auto* layout = new QVBoxLayout{this};
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(makeBar());
  layout->addWidget(pages_, 1);
  setFocusProxy(table_);
  // Another site's revisions say nothing of this one.
  connect(&document_, &SiteDocument::replaced, this, [this] { setRevisions({}); });
  connect(&document_, &SiteDocument::changed, this, &RevisionPanel::compareAgain);
  connect(comparer_, &Comparer::compared, this, &RevisionPanel::takeUp);
  retranslate();
  refresh();
}

// A field that has the focus finishes its editing while the window goes, when this is a panel no more.
RevisionPanel::~RevisionPanel() { author_->disconnect(this); }

QWidget* RevisionPanel::makeBar() {
  const auto make = [this](const char* name, const char* picture) {
    auto* action = new QAction{icon(QString::fromLatin1(picture)), {}, this};
    action->setObjectName(QString::fromLatin1(name));
    return action;
  };
  back_ = make("goBackToRevision", "revert");
  export_ = make("exportRevision", "export");
  leave_ = make("leaveRevision", "close");
  leave_->setShortcut(Qt::Key_Escape);
  leave_->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  addAction(leave_);
  connect(back_, &QAction::triggered, this, &RevisionPanel::goBack);
  connect(export_, &QAction::triggered, this, [this] {
    if (revision_) Q_EMIT exportWanted(revision_, chosen_->when);
  });
  connect(leave_, &QAction::triggered, this, &RevisionPanel::leave);
  auto* bar = new QToolBar;
  const int side = fontMetrics().height() + 2;
  bar->setIconSize({side, side});
  bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  bar->addActions({back_, export_, leave_});
  authorLabel_ = new QLabel;
  author_ = new QLineEdit;
  author_->setObjectName(QStringLiteral("revisionAuthor"));
  author_->setMaxLength(80);
  author_->setMaximumWidth(12 * side);
  authorLabel_->setBuddy(author_);
  connect(author_, &QLineEdit::editingFinished, this, [this] { Q_EMIT authorChanged(author_->text().trimmed()); });
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout{row};
  layout->setContentsMargins(0, 0, fontMetrics().height() / 2, 0);
  layout->addWidget(bar, 1);
  layout->addWidget(authorLabel_);
  layout->addWidget(author_);
  return row;
}

QWidget* RevisionPanel::makeDifferences() {
  auto* side = new QWidget;
  auto* layout = new QVBoxLayout{side};
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  head_ = new QLabel;
  head_->setObjectName(QStringLiteral("revisionHead"));
  head_->setWordWrap(true);
  head_->setMargin(fontMetrics().height() / 3);
  list_ = new QListWidget;
  list_->setObjectName(QStringLiteral("revisionDifferences"));
  list_->setWordWrap(true);
  list_->setResizeMode(QListView::Adjust);
  connect(list_, &QListWidget::currentRowChanged, this, [this] {
    if (!filling_) Q_EMIT changed();
  });
  connect(list_, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) { goTo(list_->row(item)); });
  connect(list_, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) { goTo(list_->row(item)); });
  layout->addWidget(head_);
  layout->addWidget(list_, 1);
  return side;
}

void RevisionPanel::retranslate() {
  setWindowTitle(tr("Revisions"));
  back_->setText(tr("&Go back to this one"));
  back_->setToolTip(tr("Put the site back as it was then, as one step that can be undone"));
  export_->setText(tr("Save as a &file…"));
  export_->setToolTip(tr("Write this revision to a file of its own; the open site stays as it is"));
  leave_->setText(tr("&End comparing"));
  leave_->setToolTip(tr("Take the differences off the floor (Esc)"));
  authorLabel_->setText(tr("You save as:"));
  author_->setToolTip(tr("The name that stands beside what you save"));
  author_->setAccessibleName(tr("The name that stands beside what you save"));
  table_->setAccessibleName(tr("Revisions"));
  list_->setAccessibleName(tr("What has changed since"));
}

void RevisionPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange ||
      event->type() == QEvent::PaletteChange) {
    retranslate();
    model_->retranslate();
    fillList();
    refresh();
    Q_EMIT changed();
  }
  QWidget::changeEvent(event);
}

}  // namespace tessera::ui
