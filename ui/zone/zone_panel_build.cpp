// The widgets of the zone panel and its actions.
#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSplitter>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/base/empty_page.h"
#include "ui/base/icon.h"
#include "ui/base/name_list.h"
#include "ui/base/number_delegate.h"
#include "ui/base/place_table.h"
#include "ui/base/tidy.h"
#include "ui/zone/zone_panel.h"
#include "ui/zone/zone_words.h"

namespace tessera::ui {

void ZonePanel::makeActions() {
  const auto make = [this](const char* name, const char* picture, const QKeySequence& key = {}) {
    auto* action = new QAction{icon(picture), {}, this};
    action->setObjectName(name);
    action->setShortcut(key);
    action->setShortcutContext(Qt::WidgetShortcut);
    return action;
  };
  draw_ = make("drawZoneAction", "add");
  rename_ = make("renameZoneAction", "rename", Qt::Key_F2);
  duplicate_ = make("duplicateZoneAction", "duplicate");
  delete_ = make("deleteZoneAction", "delete", QKeySequence::Delete);
  insertCorner_ = make("insertCornerAction", "add", Qt::Key_Insert);
  deleteCorner_ = make("deleteCornerAction", "delete", QKeySequence::Delete);
  connect(draw_, &QAction::triggered, this, [this] { Q_EMIT drawRequested(kindOfNew()); });
  connect(rename_, &QAction::triggered, this, &ZonePanel::startRenaming);
  connect(duplicate_, &QAction::triggered, this, &ZonePanel::duplicate);
  connect(delete_, &QAction::triggered, this, [this] { tell(edits_.remove(selection_.zone())); });
  connect(insertCorner_, &QAction::triggered, this, &ZonePanel::insertCorner);
  connect(deleteCorner_, &QAction::triggered, this, &ZonePanel::deleteCorner);
  auto* kinds = new QMenu{this};
  for (const floor::ZoneKind kind : kZoneKinds) {
    QAction* action = kinds->addAction(QString{}, this, [this, kind] { Q_EMIT drawRequested(kind); });
    action->setObjectName(QStringLiteral("drawZoneKind%1").arg(static_cast<int>(kind)));
  }
  draw_->setMenu(kinds);
}

QWidget* ZonePanel::makeEmptyPage() {
  emptyText_ = new QLabel;
  emptyButton_ = new QPushButton{icon("zone"), {}};
  emptyButton_->setObjectName("drawFirstZone");
  connect(emptyButton_, &QPushButton::clicked, this, [this] { Q_EMIT drawRequested(floor::ZoneKind::Running); });
  return emptyPage(emptyText_, emptyButton_);
}

QWidget* ZonePanel::makeListPage() {
  auto* page = new QSplitter{Qt::Vertical};
  page->setObjectName("zoneSplitter");
  page->setChildrenCollapsible(false);
  auto* upper = new QWidget;
  auto* layout = new QVBoxLayout{upper};
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  zoneBar_ = new QToolBar;
  const int side = fontMetrics().height() + 2;
  zoneBar_->setIconSize({side, side});
  zoneBar_->addActions({draw_, rename_, duplicate_, delete_});
  if (auto* button = qobject_cast<QToolButton*>(zoneBar_->widgetForAction(draw_)))
    button->setPopupMode(QToolButton::MenuButtonPopup);
  list_ = new NameList{"zoneList"};
  list_->setIconSize({side, side});
  list_->addActions({rename_, duplicate_, delete_});
  connect(list_, &NameList::nameChosen, this, [this](const QString& name) {
    selection_.setZone(name);
    Q_EMIT zoneActivated();
  });
  connect(list_, &QListWidget::itemClicked, this, &ZonePanel::zoneActivated);
  connect(list_, &NameList::renameRequested, this, [this](const QString& from, const QString& to) {
    tell(edits_.rename(from, to));
    refreshList();  // a name that was refused gives way to the old one
  });
  layout->addWidget(zoneBar_);
  layout->addWidget(list_);
  details_ = makeDetails();
  page->addWidget(upper);
  page->addWidget(details_);
  page->setStretchFactor(0, 2);
  page->setStretchFactor(1, 3);
  return page;
}

QWidget* ZonePanel::makeForm() {
  auto* page = new QWidget;
  kind_ = new QComboBox;
  kind_->setObjectName("zoneKind");
  for (std::size_t n = 0; n < kZoneKinds.size(); ++n) kind_->addItem({});
  connect(kind_, &QComboBox::activated, this,
          [this](int index) { tell(edits_.setKind(selection_.zone(), static_cast<floor::ZoneKind>(index))); });
  const auto makeBox = [](const char* name, double low, double high, double step, int decimals) {
    auto* box = new QDoubleSpinBox;
    box->setObjectName(name);
    box->setDecimals(decimals);
    box->setRange(low, high);
    box->setSingleStep(step);
    box->setKeyboardTracking(false);
    return box;
  };
  speed_ = makeBox("zoneSpeed", ZoneEdits::kLeastSpeed.value(), ZoneEdits::kMostSpeed.value(), 0.01, 2);
  connect(speed_, &QDoubleSpinBox::valueChanged, this, [this](double speed) {
    if (!filling_) tell(edits_.setSpeed(selection_.zone(), MetresPerSecond{speed}, valueKey_));
  });
  direction_ = makeBox("zoneDirection", 0.0, 359.9, 15.0, 1);
  direction_->setWrapping(true);
  connect(direction_, &QDoubleSpinBox::valueChanged, this, [this](double turn) {
    if (!filling_) tell(edits_.setDirection(selection_.zone(), fromDegrees(turn), valueKey_ + 500'000));
  });
  const auto label = [](QWidget* buddy) {
    auto* made = new QLabel;
    made->setBuddy(buddy);
    return made;
  };
  kindLabel_ = label(kind_);
  speedLabel_ = label(speed_);
  directionLabel_ = label(direction_);
  areaLabel_ = new QLabel;
  area_ = new QLabel;
  area_->setObjectName("zoneArea");
  area_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* form = new QFormLayout{page};
  form->addRow(kindLabel_, kind_);
  form->addRow(speedLabel_, speed_);
  form->addRow(directionLabel_, direction_);
  form->addRow(areaLabel_, area_);
  return page;
}

QWidget* ZonePanel::makeDetails() {
  auto* page = new QWidget;
  page->setObjectName("zoneDetails");
  cornerBar_ = new QToolBar;
  const int side = fontMetrics().height() + 2;
  cornerBar_->setIconSize({side, side});
  cornerBar_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  cornerBar_->addActions({insertCorner_, deleteCorner_});
  table_ = new PlaceTable{"cornerTable", corners_};
  const double most = 100.0 * kFarthest.value();
  table_->setItemDelegate(new NumberDelegate{{"centimetreEditor", 1, -most, most, 1.0}, table_});
  table_->addActions({insertCorner_, deleteCorner_});
  connect(table_->selectionModel(), &QItemSelectionModel::currentChanged, this, [this] {
    deleteCorner_->setEnabled(currentCorner() && corners_->rowCount() > 3);
    if (!filling_) Q_EMIT cornerSelected(currentCorner());
  });
  auto* layout = new QVBoxLayout{page};
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(makeForm());
  layout->addWidget(cornerBar_);
  layout->addWidget(table_, 1);
  return page;
}

}  // namespace tessera::ui
