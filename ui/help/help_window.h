// The help: contents and search at the left, the page at the right, back and forward as in a browser.
#pragma once

#include <QAction>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QSplitter>
#include <QTextBrowser>
#include <QToolBar>
#include <QWidget>

#include "ui/help/help_pages.h"
#include "ui/help/help_topic.h"

namespace tessera::ui {

class HelpWindow : public QWidget {
  Q_OBJECT
public:
  /// A window of its own, also with a parent.
  explicit HelpWindow(QWidget* parent = nullptr);

  /// Shows that page; the first one when there is no such topic.
  void showTopic(const QString& topic);
  [[nodiscard]] const QString& topic() const { return topic_; }

protected:
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  void layOut();
  void retranslate();
  void fill();
  void markHits();
  void smoothTables();
  void follow(const QUrl& url);

  HelpPages pages_;
  QString topic_;
  QSplitter splitter_;  // before what lies in it, so that it goes after
  QToolBar bar_;
  QAction back_;
  QAction forward_;
  QAction home_;
  QLineEdit search_;
  QLabel none_;
  QListWidget contents_;
  QTextBrowser browser_;
};

}  // namespace tessera::ui
