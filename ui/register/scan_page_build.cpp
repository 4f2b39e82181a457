// How the page is laid out, and its words that never change while tags are registered.
#include <QGridLayout>
#include <QScrollArea>
#include <QVBoxLayout>
#include <utility>

#include "ui/base/icon.h"
#include "ui/register/scan_page.h"

namespace tessera::ui {

void ScanPage::build() {
  QFont large = title_.font();
  large.setPointSizeF(large.pointSizeF() * 1.6);
  large.setBold(true);
  title_.setFont(large);
  for (QLabel* label : {&title_, &detail_, &contact_, &count_}) label->setWordWrap(true);
  const std::pair<QObject*, const char*> names[] = {
      {&title_, "scanTitle"},       {&detail_, "scanDetail"}, {&contact_, "scanContact"},   {&count_, "scanCount"},
      {&notice_, "scanNotice"},     {&where_, "scanWhere"},   {&bar_, "scanProgress"},      {&back_, "scanBack"},
      {&skip_, "scanSkip"},         {&pause_, "scanPause"},   {&end_, "scanEnd"},           {&skipped_, "scanSkipped"},
      {&previous_, "scanPrevious"}, {&next_, "scanNext"},     {&exchange_, "scanExchange"}, {&anew_, "scanAnew"},
      {&sounds_, "scanSound"},      {&deaf_, "scanDeaf"}};
  for (const auto& [object, name] : names) object->setObjectName(QString::fromLatin1(name));
  back_.setIcon(icon(QStringLiteral("undo")));
  skip_.setIcon(icon(QStringLiteral("to-end")));
  end_.setIcon(icon(QStringLiteral("close")));
  where_.setIcon(icon(QStringLiteral("place")));
  exchange_.setIcon(icon(QStringLiteral("reverse")));
  anew_.setIcon(icon(QStringLiteral("revert")));
  previous_.setIcon(icon(QStringLiteral("arrow-left")));
  next_.setIcon(icon(QStringLiteral("arrow-right")));
  bar_.setTextVisible(false);
  // A reader's Enter must press none of them.
  for (QAbstractButton* button : std::initializer_list<QAbstractButton*>{
           &where_, &exchange_, &anew_, &back_, &skip_, &pause_, &end_, &skipped_, &previous_, &next_, &sounds_})
    button->setFocusPolicy(Qt::TabFocus);

  auto* head = new QHBoxLayout;
  head->addWidget(&title_, 1);
  head->addWidget(&previous_);
  head->addWidget(&next_);
  auto* buttons = new QGridLayout;
  buttons->addWidget(&back_, 0, 0);
  buttons->addWidget(&skip_, 0, 1);
  buttons->addWidget(&pause_, 1, 0);
  buttons->addWidget(&end_, 1, 1);
  // What there is no room for scrolls; the buttons stay where they are.
  auto* inner = new QWidget;
  auto* column = new QVBoxLayout{inner};
  column->addLayout(head);
  column->addWidget(&detail_);
  column->addWidget(&deaf_);
  column->addWidget(&picture_, 1);
  column->addWidget(&notice_);
  column->addWidget(&where_);
  column->addWidget(&exchange_);
  column->addWidget(&anew_);
  column->addWidget(&skipped_);
  column->addWidget(&bar_);
  column->addWidget(&count_);
  auto* foot = new QHBoxLayout;
  foot->addWidget(&contact_, 1);
  foot->addWidget(&sounds_);
  column->addLayout(foot);
  auto* scroll = new QScrollArea;
  scroll->setObjectName(QStringLiteral("scanScroll"));
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(inner);
  auto* outer = new QVBoxLayout{this};
  outer->setContentsMargins(0, 0, 0, 0);
  outer->addWidget(scroll, 1);
  buttons->setContentsMargins(column->contentsMargins());
  outer->addLayout(buttons);
  for (QWidget* later : {&where_, &exchange_, &anew_, &skipped_}) later->hide();
}

void ScanPage::retranslate() {
  back_.setText(tr("One back"));
  back_.setToolTip(tr("Take the last tag back (Backspace)"));
  skip_.setText(tr("Skip"));
  skip_.setToolTip(tr("This tag is dead or missing (Del)"));
  end_.setText(tr("Stop"));
  end_.setToolTip(tr("To go on another time"));
  skipped_.setText(tr("Visit the skipped places"));
  pause_.setToolTip(tr("Reads do not count meanwhile (Pause)"));
  anew_.setText(tr("Read the whole tile anew"));
  anew_.setToolTip(tr("Its tags are taken off and read from the first one on"));
  sounds_.setText(tr("Sounds"));
  previous_.setAccessibleName(tr("Previous place"));
  previous_.setToolTip(tr("Previous place (Page Up)"));
  next_.setAccessibleName(tr("Next place"));
  next_.setToolTip(tr("Next place (Page Down)"));
  refresh();
}

}  // namespace tessera::ui
