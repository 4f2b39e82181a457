#include "ui/connect/start_page.h"

#include <QEvent>
#include <QVBoxLayout>
#include <utility>

namespace tessera::ui {

StartPage::StartPage(QWidget* parent)
    : QWidget{parent}, demo_{QStringLiteral("demo")}, new_{QStringLiteral("new")}, open_{QStringLiteral("open")} {
  setProperty("helpTopic", QStringLiteral("start"));
  QFont large = font();
  large.setPointSizeF(large.pointSizeF() * 2.6);
  large.setBold(true);
  name_.setFont(large);
  sentence_.setWordWrap(true);
  demo_.setObjectName(QStringLiteral("demoButton"));
  new_.setObjectName(QStringLiteral("newButton"));
  open_.setObjectName(QStringLiteral("openButton"));

  const int line = fontMetrics().height();
  auto* column = new QVBoxLayout;
  column->addStretch(1);
  column->addWidget(&name_);
  column->addWidget(&sentence_);
  column->addSpacing(line);
  for (BigButton* button : {&demo_, &new_, &open_}) column->addWidget(button);
  column->addSpacing(line);
  column->addWidget(&recent_, 4);
  column->addStretch(1);
  auto* inner = new QWidget;
  inner->setLayout(column);
  inner->setMaximumWidth(line * 44);
  auto* row = new QHBoxLayout{this};
  row->addStretch(1);
  row->addWidget(inner, 20);
  row->addStretch(1);
  setFocusProxy(&demo_);

  connect(&demo_, &QPushButton::clicked, this, &StartPage::demoRequested);
  connect(&new_, &QPushButton::clicked, this, &StartPage::newRequested);
  connect(&open_, &QPushButton::clicked, this, &StartPage::openRequested);
  connect(&recent_, &RecentList::chosen, this, &StartPage::recentRequested);
  connect(&recent_, &RecentList::forgotten, this, &StartPage::forgetRequested);
  retranslate();
}

void StartPage::setRecent(std::vector<RecentSite> sites) { recent_.setSites(std::move(sites)); }

void StartPage::retranslate() {
  name_.setText(tr("Tessera"));
  sentence_.setText(tr("Watch and guide automated vehicles that find their way by RFID tags in a tile floor."));
  demo_.setTexts(tr("&Demo floor"), tr("A simulated floor with a vehicle to drive. Nothing to plug in."));
  new_.setTexts(tr("&New site"), tr("Lay a floor of so many tiles, then draw routes and set up vehicles."));
  open_.setTexts(tr("&Open…"), tr("Open a site that was saved before (*.tessera.json)."));
}

void StartPage::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

}  // namespace tessera::ui
