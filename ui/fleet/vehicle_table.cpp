#include "ui/fleet/vehicle_table.h"

#include <QApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include "ui/fleet/vehicle_delegate.h"

namespace tessera::ui {

VehicleTable::VehicleTable(FleetLink& link, Selection& selection, SiteDocument& document, QWidget* parent)
    : QWidget{parent},
      link_{link},
      selection_{selection},
      document_{document},
      model_{document},
      throttle_{100, [this] { takePicture(); }} {
  setObjectName(QStringLiteral("vehicleTable"));
  sorted_.setSourceModel(&model_);
  sorted_.setSortRole(SortRole);
  sorted_.setSortLocaleAware(true);
  // Rows that jump about while one reaches for them are worse than rows that are out of order for a second.
  sorted_.setDynamicSortFilter(false);
  build();
  connect(&link_, &FleetLink::snapshotChanged, this, [this] {
    if (isVisible()) throttle_.request();
  });
  connect(&document_, &SiteDocument::changed, this, [this] {
    showWhatThereIs();
    followSelection();
  });
  connect(&selection_, &Selection::vehicleChanged, this, &VehicleTable::followSelection);
  connect(&model_, &QAbstractItemModel::dataChanged, this, [this](const QModelIndex& first, const QModelIndex& last) {
    sortKeyChanged_ =
        sortKeyChanged_ || (first.column() <= sorted_.sortColumn() && sorted_.sortColumn() <= last.column());
  });
  connect(&sortTimer_, &QTimer::timeout, this, &VehicleTable::sortAgain);
  sortTimer_.start(1000);
  model_.setPalette(palette());
  retranslate();
  takePicture();
  sizeColumns();
  followSelection();
}

void VehicleTable::build() {
  view_ = new QTreeView{this};
  view_->setObjectName(QStringLiteral("vehicleList"));
  view_->setModel(&sorted_);
  view_->setItemDelegate(new VehicleDelegate{view_});
  view_->setRootIsDecorated(false);
  view_->setUniformRowHeights(true);
  view_->setAllColumnsShowFocus(true);
  view_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  view_->setContextMenuPolicy(Qt::CustomContextMenu);
  view_->setFrameShape(QFrame::NoFrame);
  view_->setSortingEnabled(true);
  view_->sortByColumn(-1, Qt::AscendingOrder);  // the order of the site
  view_->header()->setSectionsMovable(true);
  view_->header()->setStretchLastSection(true);
  connect(view_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &VehicleTable::takeCurrent);
  connect(view_, &QWidget::customContextMenuRequested, this, &VehicleTable::openMenu);
  connect(view_, &QAbstractItemView::activated, this, [this](const QModelIndex& index) {
    if (const auto id = vehicleAt(index)) Q_EMIT followRequested(*id);
  });

  noVehicles_ = new FleetHint{QStringLiteral("vehicle"), this};
  noVehicles_->button()->setObjectName(QStringLiteral("commissionButton"));
  connect(noVehicles_->button(), &QPushButton::clicked, this, &VehicleTable::commissionRequested);

  banner_ = new QWidget{this};
  bannerText_ = new QLabel{banner_};
  bannerText_->setWordWrap(true);
  bannerText_->setTextFormat(Qt::PlainText);
  bannerText_->setObjectName(QStringLiteral("connectionText"));
  connectButton_ = new QPushButton{banner_};
  connectButton_->setObjectName(QStringLiteral("connectButton"));
  connect(connectButton_, &QPushButton::clicked, this, &VehicleTable::connectRequested);
  auto* row = new QHBoxLayout{banner_};
  row->addWidget(bannerText_, 1);
  row->addWidget(connectButton_);

  auto* list = new QWidget{this};
  auto* column = new QVBoxLayout{list};
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(banner_);
  column->addWidget(view_, 1);
  pages_ = new QStackedLayout{this};
  pages_->addWidget(list);
  pages_->addWidget(noVehicles_);
}

void VehicleTable::retranslate() {
  view_->setAccessibleName(tr("Vehicles"));
  noVehicles_->setTexts(tr("This site has no vehicle yet. Set one up: the wizard leads through it."),
                        tr("Set &up a vehicle…"));
  connectButton_->setText(tr("Co&nnect…"));
  model_.refreshTexts();
  showWhatThereIs();
}

void VehicleTable::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange) retranslate();
  if (event->type() == QEvent::PaletteChange) model_.setPalette(palette());
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::FontChange) sizeColumns();
  QWidget::changeEvent(event);
}

void VehicleTable::showEvent(QShowEvent* event) {
  takePicture();
  QWidget::showEvent(event);
}

void VehicleTable::takePicture() {
  model_.setSnapshot(link_.latest());
  showWhatThereIs();
}

void VehicleTable::showWhatThereIs() {
  const bool some = model_.rowCount() > 0;
  pages_->setCurrentIndex(some ? 0 : 1);
  const auto snapshot = link_.latest();
  const bool connected = snapshot && snapshot->port.state == supervisor::PortState::Open;
  banner_->setVisible(!connected);
  if (!connected) bannerText_->setText(situation(snapshot.get(), nullptr, {}));
}

std::optional<VehicleId> VehicleTable::vehicleAt(const QModelIndex& shown) const {
  if (!shown.isValid()) return std::nullopt;
  return model_.idAt(sorted_.mapToSource(shown).row());
}

void VehicleTable::followSelection() {
  const auto& vehicles = document_.site().vehicles;
  auto wanted = selection_.vehicle();
  if (wanted && model_.rowOf(*wanted) < 0) wanted.reset();
  if (!wanted && vehicles.size() == 1) wanted = vehicles.front().id;  // no choice to make
  if (wanted != selection_.vehicle()) return selection_.setVehicle(wanted);
  following_ = true;
  if (!wanted) {
    view_->setCurrentIndex({});
  } else if (wanted != vehicleAt(view_->currentIndex())) {
    view_->setCurrentIndex(sorted_.mapFromSource(model_.index(model_.rowOf(*wanted), 0)));
  }
  following_ = false;
}

void VehicleTable::takeCurrent(const QModelIndex& current) {
  if (following_ || !current.isValid()) return;
  selection_.setVehicle(vehicleAt(current));
}

void VehicleTable::sortAgain() {
  if (!sortKeyChanged_ || sorted_.sortColumn() < 0 || !isVisible() || QApplication::mouseButtons() != Qt::NoButton)
    return;
  sortKeyChanged_ = false;
  sorted_.sort(sorted_.sortColumn(), sorted_.sortOrder());
}

void VehicleTable::sizeColumns() {
  const QFontMetrics metrics = view_->fontMetrics();
  const int digit = metrics.averageCharWidth();
  const int icon = metrics.height() * 2;
  const auto atLeast = [&](int column, const QString& sample, int extra) {
    const int header = view_->header()->sectionSizeHint(column);
    view_->setColumnWidth(column, std::max(header, metrics.horizontalAdvance(sample) + extra));
  };
  atLeast(VehicleModel::Name, QStringLiteral("AGV 100"), icon + 4 * digit);
  atLeast(VehicleModel::State, words(Condition::NoPort), icon);
  atLeast(VehicleModel::Progress, QStringLiteral("100 %"), 12 * digit);
  atLeast(VehicleModel::RouteName, QStringLiteral("route 100"), 3 * digit);
  atLeast(VehicleModel::Speed, QStringLiteral("0.00 m/s"), 2 * digit);
  atLeast(VehicleModel::Battery, QStringLiteral("24.0 V"), icon);
  atLeast(VehicleModel::Link, tr("%1 % lost").arg(100), icon);
  atLeast(VehicleModel::Age, QStringLiteral("9999 s"), 2 * digit);
  atLeast(VehicleModel::Place, QStringLiteral("± 100.0 cm"), 2 * digit);
}

QByteArray VehicleTable::saveState() const { return view_->header()->saveState(); }
void VehicleTable::restoreState(const QByteArray& state) { view_->header()->restoreState(state); }

}  // namespace tessera::ui
