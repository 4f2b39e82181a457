// The widgets of the route panel, their actions and their texts.
#include <QAction>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSplitter>
#include <QStackedWidget>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/base/empty_page.h"
#include "ui/base/icon.h"
#include "ui/base/name_list.h"
#include "ui/base/number_delegate.h"
#include "ui/base/place_table.h"
#include "ui/base/tidy.h"
#include "ui/route/route_panel.h"

namespace tessera::ui {

void RoutePanel::makeActions() {
  const auto make = [this](const char* name, const char* picture) {
    auto* action = new QAction{icon(picture), {}, this};
    action->setObjectName(name);
    return action;
  };
  draw_ = make("drawRouteAction", "add");
  rename_ = make("renameRouteAction", "rename");
  duplicate_ = make("duplicateRouteAction", "duplicate");
  reverse_ = make("reverseRouteAction", "reverse");
  join_ = make("joinRouteAction", "join");
  join_->setMenu(new QMenu{this});
  split_ = make("splitRouteAction", "split");
  delete_ = make("deleteRouteAction", "delete");
  insertVertex_ = make("insertVertexAction", "add");
  deleteVertex_ = make("deleteVertexAction", "delete");
  rename_->setShortcut(Qt::Key_F2);
  delete_->setShortcut(QKeySequence::Delete);
  insertVertex_->setShortcut(Qt::Key_Insert);
  deleteVertex_->setShortcut(QKeySequence::Delete);
  for (QAction* action : {rename_, delete_, insertVertex_, deleteVertex_})
    action->setShortcutContext(Qt::WidgetShortcut);
  connect(draw_, &QAction::triggered, this, &RoutePanel::drawRequested);
  connect(rename_, &QAction::triggered, this, &RoutePanel::startRenaming);
  connect(duplicate_, &QAction::triggered, this, &RoutePanel::duplicate);
  connect(reverse_, &QAction::triggered, this, [this] { tell(edits_.reverse(selection_.route())); });
  connect(join_, &QAction::triggered, this, &RoutePanel::join);
  connect(split_, &QAction::triggered, this, &RoutePanel::split);
  connect(delete_, &QAction::triggered, this, [this] { tell(edits_.remove(selection_.route())); });
  connect(insertVertex_, &QAction::triggered, this, &RoutePanel::insertVertex);
  connect(deleteVertex_, &QAction::triggered, this, &RoutePanel::deleteVertex);
}

QWidget* RoutePanel::makeEmptyPage() {
  emptyText_ = new QLabel;
  emptyButton_ = new QPushButton{icon("route"), {}};
  emptyButton_->setObjectName("drawFirstRoute");
  connect(emptyButton_, &QPushButton::clicked, this, &RoutePanel::drawRequested);
  return emptyPage(emptyText_, emptyButton_);
}

QWidget* RoutePanel::makeListPage() {
  auto* page = new QSplitter{Qt::Vertical};
  page->setObjectName("routeSplitter");
  page->setChildrenCollapsible(false);
  auto* upper = new QWidget;
  auto* layout = new QVBoxLayout{upper};
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  routeBar_ = new QToolBar;
  const int side = fontMetrics().height() + 2;
  routeBar_->setIconSize({side, side});
  routeBar_->addActions({draw_, rename_, duplicate_, reverse_, join_, delete_});
  if (auto* button = qobject_cast<QToolButton*>(routeBar_->widgetForAction(join_)))
    button->setPopupMode(QToolButton::InstantPopup);
  list_ = new NameList{"routeList"};
  list_->addActions({rename_, duplicate_, reverse_, join_, delete_});
  connect(list_, &NameList::nameChosen, &selection_, &Selection::setRoute);
  connect(list_, &NameList::renameRequested, this, [this](const QString& from, const QString& to) {
    tell(edits_.rename(from, to));
    refreshList();  // a name that was refused gives way to the old one
  });
  layout->addWidget(routeBar_);
  layout->addWidget(list_);
  details_ = makeDetails();
  page->addWidget(upper);
  page->addWidget(details_);
  page->setStretchFactor(0, 2);
  page->setStretchFactor(1, 3);
  return page;
}

QWidget* RoutePanel::makeDetails() {
  auto* page = new QWidget;
  page->setObjectName("routeDetails");
  vertexBar_ = new QToolBar;
  const int side = fontMetrics().height() + 2;
  vertexBar_->setIconSize({side, side});
  vertexBar_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  vertexBar_->addActions({insertVertex_, deleteVertex_, split_});
  table_ = new PlaceTable{"vertexTable", vertices_};
  const double most = kFarthest.value();
  table_->setItemDelegate(new NumberDelegate{{"metreEditor", 3, -most, most, 0.01}, table_});
  table_->setItemDelegateForColumn(
      VertexModel::kSpeed,
      new NumberDelegate{{"legSpeedEditor", 3, 0.0, RouteEdits::kMostSpeed.value(), 0.05, true}, table_});
  // Their headings are longer than their numbers.
  for (const int column : {VertexModel::kLeg, VertexModel::kSpeed})
    table_->horizontalHeader()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
  table_->addActions({insertVertex_, deleteVertex_, split_});
  connect(table_->selectionModel(), &QItemSelectionModel::currentChanged, this, [this] {
    refreshActions();
    if (!filling_) Q_EMIT vertexSelected(currentVertex());
  });
  const auto makeBox = [](const char* name, double low, double high, double step) {
    auto* box = new QDoubleSpinBox;
    box->setObjectName(name);
    box->setDecimals(2);
    box->setRange(low, high);
    box->setSingleStep(step);
    box->setKeyboardTracking(false);
    return box;
  };
  spacing_ = makeBox("controlSpacing", RouteEdits::kLeastSpacing.value(), RouteEdits::kMostSpacing.value(), 0.05);
  connect(spacing_, &QDoubleSpinBox::valueChanged, this, [this](double metres) {
    if (!filling_) tell(edits_.setSpacing(selection_.route(), Metres{metres}, spacingKey_));
  });
  speed_ = makeBox("estimateSpeed", 0.01, 20.0, 0.05);
  speed_->setValue(0.20);
  connect(speed_, &QDoubleSpinBox::valueChanged, this, &RoutePanel::refreshTime);
  spacingLabel_ = new QLabel;
  spacingLabel_->setBuddy(spacing_);
  speedLabel_ = new QLabel;
  speedLabel_->setBuddy(speed_);
  lengthLabel_ = new QLabel;
  length_ = new QLabel;
  length_->setObjectName("routeLength");
  length_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* form = new QFormLayout;
  form->addRow(spacingLabel_, spacing_);
  form->addRow(speedLabel_, speed_);
  form->addRow(lengthLabel_, length_);
  auto* layout = new QVBoxLayout{page};
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(vertexBar_);
  layout->addWidget(table_, 1);
  layout->addLayout(form);
  return page;
}

void RoutePanel::retranslate() {
  emptyText_->setText(
      tr("This site has no route yet. A route is the way that a vehicle drives: click its vertices on the floor."));
  emptyButton_->setText(tr("&Draw a route"));
  const auto name = [](QAction* action, const QString& text, const QString& tip) {
    action->setText(text);
    action->setToolTip(action->shortcut().isEmpty()
                           ? tip
                           : QStringLiteral("%1 (%2)").arg(tip, action->shortcut().toString(QKeySequence::NativeText)));
  };
  name(draw_, tr("&New route"), tr("Draw a new route on the floor"));
  name(rename_, tr("Re&name"), tr("Rename the route"));
  name(duplicate_, tr("D&uplicate"), tr("Make another route of the same vertices"));
  name(reverse_, tr("&Reverse"), tr("Drive the route the other way round"));
  name(join_, tr("&Join"), tr("Make one route of this one and another whose end touches"));
  name(split_, tr("&Split"), tr("Make two routes of this one, at the chosen vertex"));
  name(delete_, tr("&Delete route"), tr("Delete the route"));
  name(insertVertex_, tr("&Insert vertex"), tr("Insert a vertex after the chosen one"));
  name(deleteVertex_, tr("Delete &vertex"), tr("Delete the chosen vertex"));
  list_->setAccessibleName(tr("Routes"));
  table_->setAccessibleName(tr("Vertices of the route"));
  spacingLabel_->setText(tr("Control points every"));
  spacing_->setSuffix(tr(" m"));
  spacing_->setToolTip(tr("Distance of the points that the vehicle is led to, one after the other"));
  speedLabel_->setText(tr("Time when driven at"));
  speed_->setSuffix(tr(" m/s"));
  speed_->setToolTip(tr("For the driving time shown below; each run has a speed of its own"));
  lengthLabel_->setText(tr("Length and time"));
}

}  // namespace tessera::ui
