#include "ui/help/help_window.h"

#include <QDesktopServices>
#include <QEvent>
#include <QFileInfo>
#include <QKeyEvent>
#include <QTextDocument>
#include <QTextFrame>
#include <QTextTable>
#include <QVBoxLayout>

#include "ui/base/icon.h"

namespace tessera::ui {

HelpWindow::HelpWindow(QWidget* parent) : QWidget{parent, Qt::Window} {
  setObjectName(QStringLiteral("helpWindow"));
  back_.setIcon(icon(QStringLiteral("arrow-left")));
  back_.setShortcut(QKeySequence::Back);
  forward_.setIcon(icon(QStringLiteral("arrow-right")));
  forward_.setShortcut(QKeySequence::Forward);
  home_.setIcon(icon(QStringLiteral("home")));
  search_.setObjectName(QStringLiteral("helpSearch"));
  search_.setClearButtonEnabled(true);
  contents_.setObjectName(QStringLiteral("helpContents"));
  browser_.setObjectName(QStringLiteral("helpPage"));
  browser_.setOpenLinks(false);
  none_.setWordWrap(true);
  none_.hide();
  layOut();

  connect(&back_, &QAction::triggered, &browser_, &QTextBrowser::backward);
  connect(&forward_, &QAction::triggered, &browser_, &QTextBrowser::forward);
  connect(&home_, &QAction::triggered, this, [this] { showTopic(HelpPages::topics().front()); });
  connect(&browser_, &QTextBrowser::backwardAvailable, &back_, &QAction::setEnabled);
  connect(&browser_, &QTextBrowser::forwardAvailable, &forward_, &QAction::setEnabled);
  connect(&browser_, &QTextBrowser::anchorClicked, this, &HelpWindow::follow);
  connect(&browser_, &QTextBrowser::sourceChanged, this, [this](const QUrl& url) {
    topic_ = QFileInfo{url.path()}.completeBaseName();
    smoothTables();
    const QSignalBlocker quiet{&contents_};
    for (int i = 0; i < contents_.count(); ++i)
      if (contents_.item(i)->data(Qt::UserRole).toString() == topic()) contents_.setCurrentRow(i);
    markHits();
  });
  connect(&contents_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
    if (item != nullptr) browser_.setSource(pages_.url(item->data(Qt::UserRole).toString()));
  });
  connect(&search_, &QLineEdit::textChanged, this, &HelpWindow::fill);
  connect(&search_, &QLineEdit::returnPressed, this, [this] {
    if (contents_.count() > 0) browser_.setSource(pages_.url(contents_.item(0)->data(Qt::UserRole).toString()));
  });
  back_.setEnabled(false);
  forward_.setEnabled(false);
  retranslate();
  browser_.setSource(pages_.url(HelpPages::topics().front()));
  const int line = fontMetrics().height();
  resize(line * 52, line * 36);
}

void HelpWindow::layOut() {
  bar_.addActions({&back_, &forward_, &home_});
  auto* left = new QWidget;
  auto* column = new QVBoxLayout{left};
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(&search_);
  column->addWidget(&none_);
  column->addWidget(&contents_, 1);
  splitter_.addWidget(left);
  splitter_.addWidget(&browser_);
  splitter_.setStretchFactor(1, 1);
  splitter_.setChildrenCollapsible(false);
  const int line = fontMetrics().height();
  splitter_.setSizes({line * 14, line * 38});
  browser_.document()->setDocumentMargin(line);
  auto* whole = new QVBoxLayout{this};
  whole->addWidget(&bar_);
  whole->addWidget(&splitter_, 1);
}

void HelpWindow::showTopic(const QString& topic) {
  if (!search_.text().isEmpty()) search_.clear();
  browser_.setSource(pages_.url(topic));
}

void HelpWindow::fill() {
  const QSignalBlocker quiet{&contents_};
  contents_.clear();
  for (const HelpPage* p : pages_.search(search_.text())) {
    auto* item = new QListWidgetItem{p->title, &contents_};
    item->setData(Qt::UserRole, p->topic);
    if (p->topic == topic()) contents_.setCurrentItem(item);
  }
  none_.setVisible(contents_.count() == 0);
  markHits();
}

void HelpWindow::markHits() {
  QList<QTextEdit::ExtraSelection> marks;
  const QStringList words = search_.text().split(QLatin1Char(' '), Qt::SkipEmptyParts);
  QColor veil{0xe0, 0x9a, 0x10};
  veil.setAlphaF(0.35F);
  for (const QString& word : words) {
    for (QTextCursor at = browser_.document()->find(word, 0); !at.isNull(); at = browser_.document()->find(word, at)) {
      QTextEdit::ExtraSelection mark;
      mark.cursor = at;
      mark.format.setBackground(veil);
      marks.append(mark);
    }
  }
  browser_.setExtraSelections(marks);
}

// Markdown's tables come with double lines.
void HelpWindow::smoothTables() {
  for (QTextFrame* frame : browser_.document()->rootFrame()->childFrames()) {
    auto* table = qobject_cast<QTextTable*>(frame);
    if (table == nullptr) continue;
    QTextTableFormat format = table->format();
    format.setBorderCollapse(true);
    format.setBorderBrush(palette().brush(QPalette::Mid));
    format.setBorder(1);
    format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
    format.setCellPadding(fontMetrics().height() / 4.0);
    format.setCellSpacing(0);
    format.setTopMargin(fontMetrics().height() / 2.0);
    format.setBottomMargin(fontMetrics().height() / 2.0);
    table->setFormat(format);
  }
}

// Links lead to other pages as "routes.md", or out of the program.
void HelpWindow::follow(const QUrl& url) {
  if (url.scheme().startsWith(QLatin1String{"http"})) {
    QDesktopServices::openUrl(url);
    return;
  }
  browser_.setSource(pages_.url(QFileInfo{url.path()}.completeBaseName()));
}

void HelpWindow::retranslate() {
  const QString shown = topic();
  pages_ = HelpPages{};
  setWindowTitle(tr("Tessera help"));
  bar_.setAccessibleName(tr("Pages"));
  const auto with = [](const QString& text, const QAction& action) {
    return tr("%1 (%2)", "action, key").arg(text, action.shortcut().toString(QKeySequence::NativeText));
  };
  back_.setText(tr("Back"));
  back_.setToolTip(with(tr("Back"), back_));
  forward_.setText(tr("Forward"));
  forward_.setToolTip(with(tr("Forward"), forward_));
  home_.setText(tr("First page"));
  search_.setPlaceholderText(tr("Search the help"));
  search_.setAccessibleName(tr("Search the help"));
  none_.setText(tr("No page holds these words."));
  contents_.setAccessibleName(tr("Contents"));
  browser_.setAccessibleName(tr("Help page"));
  fill();
  if (!shown.isEmpty()) browser_.setSource(pages_.url(shown));
}

void HelpWindow::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    close();
  } else if (event->matches(QKeySequence::Find)) {
    search_.setFocus();
    search_.selectAll();
  } else {
    QWidget::keyPressEvent(event);
  }
}

void HelpWindow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  // Markdown takes its colours when it is read.
  if (event->type() == QEvent::PaletteChange) {
    browser_.reload();
    smoothTables();
  }
  QWidget::changeEvent(event);
}

}  // namespace tessera::ui
