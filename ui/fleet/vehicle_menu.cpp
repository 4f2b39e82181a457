// The context menu of the vehicle list: to follow a vehicle, and the orders that make sense for it.
#include <QToolTip>

#include "ui/base/icon.h"
#include "ui/fleet/order_rules.h"
#include "ui/fleet/vehicle_table.h"

namespace tessera::ui {

void VehicleTable::addOrder(QMenu& menu, const QString& text, const QString& iconName, const QString& whyNot,
                            const supervisor::Order& order, const QString& name) {
  QAction* action = menu.addAction(icon(iconName), text);
  action->setObjectName(name);
  action->setEnabled(whyNot.isEmpty());
  action->setToolTip(whyNot);
  connect(action, &QAction::triggered, this, [this, order] {
    if (!link_.post(order))
      QToolTip::showText(QCursor::pos(), tr("The order was not taken: there is no connection to the vehicles."), view_);
  });
}

void VehicleTable::openMenu(QPoint at) {
  const auto id = vehicleAt(view_->indexAt(at));
  if (!id) return;
  auto* menu = new QMenu{view_};
  menu->setObjectName(QStringLiteral("vehicleMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->setToolTipsVisible(true);
  QAction* follow = menu->addAction(icon(QStringLiteral("follow")), tr("&Follow on the floor"));
  follow->setObjectName(QStringLiteral("menuFollow"));
  connect(follow, &QAction::triggered, this, [this, vehicle = *id] { Q_EMIT followRequested(vehicle); });
  menu->addSeparator();
  const auto snapshot = link_.latest();
  OrderCase c;
  c.snapshot = snapshot.get();
  c.vehicle = *id;
  c.name = model_.data(model_.index(model_.rowOf(*id), VehicleModel::Name), Qt::DisplayRole).toString();
  addOrder(*menu, tr("&Pause"), QStringLiteral("pause"), whyNotPause(c), supervisor::Pause{*id},
           QStringLiteral("menuPause"));
  addOrder(*menu, tr("&Resume"), QStringLiteral("resume"), whyNotResume(c), supervisor::Resume{*id},
           QStringLiteral("menuResume"));
  addOrder(*menu, tr("&Stop"), QStringLiteral("stop"), whyNotStop(c), supervisor::Stop{*id},
           QStringLiteral("menuStop"));
  addOrder(*menu, tr("&Clear faults"), QStringLiteral("clear"), whyNotClear(c), supervisor::Clear{*id},
           QStringLiteral("menuClear"));
  menu->popup(view_->viewport()->mapToGlobal(at));
}

}  // namespace tessera::ui
