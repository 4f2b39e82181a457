// The list of the site's vehicles: how each one stands, how fresh that is, and orders by context menu.
#pragma once

#include <QMenu>
#include <QSortFilterProxyModel>
#include <QStackedLayout>
#include <QTimer>
#include <QTreeView>

#include "ui/base/fleet_link.h"
#include "ui/base/selection.h"
#include "ui/base/site_document.h"
#include "ui/base/throttle.h"
#include "ui/fleet/hint.h"
#include "ui/fleet/vehicle_model.h"

namespace tessera::ui {

class VehicleTable : public QWidget {
  Q_OBJECT
public:
  VehicleTable(FleetLink& link, Selection& selection, SiteDocument& document, QWidget* parent = nullptr);

  /// Widths, order and sorting of the columns, for the window's settings.
  [[nodiscard]] QByteArray saveState() const;
  void restoreState(const QByteArray& state);

Q_SIGNALS:
  /// Double click, Enter, or from the menu: the floor shall stay on this vehicle.
  void followRequested(tessera::VehicleId vehicle);
  void commissionRequested();
  void connectRequested();

protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

private:
  void retranslate();
  void build();
  void takePicture();
  void showWhatThereIs();
  void followSelection();
  void takeCurrent(const QModelIndex& current);
  void openMenu(QPoint at);
  void addOrder(QMenu& menu, const QString& text, const QString& iconName, const QString& whyNot,
                const supervisor::Order& order, const QString& name);
  void sortAgain();
  void sizeColumns();
  [[nodiscard]] std::optional<VehicleId> vehicleAt(const QModelIndex& shown) const;

  FleetLink& link_;
  Selection& selection_;
  SiteDocument& document_;
  VehicleModel model_;
  QSortFilterProxyModel sorted_;
  QTreeView* view_ = nullptr;
  FleetHint* noVehicles_ = nullptr;
  QWidget* banner_ = nullptr;
  QLabel* bannerText_ = nullptr;
  QPushButton* connectButton_ = nullptr;
  QStackedLayout* pages_ = nullptr;
  Throttle throttle_;
  QTimer sortTimer_;
  bool sortKeyChanged_ = false;
  bool following_ = false;
};

}  // namespace tessera::ui
