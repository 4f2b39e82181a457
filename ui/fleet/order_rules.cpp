#include "ui/fleet/order_rules.h"

#include <QCoreApplication>

#include "ui/fleet/condition.h"

namespace tessera::ui {
namespace {

using supervisor::Contact;
using supervisor::Task;

struct OrderWords {
  Q_DECLARE_TR_FUNCTIONS(tessera::ui::Orders)
};

const supervisor::VehicleView* viewIn(const OrderCase& c) {
  return c.snapshot == nullptr || !c.vehicle ? nullptr : c.snapshot->find(*c.vehicle);
}

// What any order needs: somebody chosen, and a supervision that knows it.
QString nobodyToTell(const OrderCase& c) {
  if (!c.vehicle) return OrderWords::tr("Choose a vehicle in the list or on the floor first.");
  if (c.snapshot == nullptr) return OrderWords::tr("There is no connection to the vehicles. Connect first.");
  if (viewIn(c) == nullptr) return OrderWords::tr("The supervision does not know %1 yet. Connect again.").arg(c.name);
  return {};
}

QString unreachable(const OrderCase& c) {
  if (QString nobody = nobodyToTell(c); !nobody.isEmpty()) return nobody;
  if (c.snapshot->port.state != supervisor::PortState::Open)
    return OrderWords::tr("The radio's port is not open. Connect first.");
  if (viewIn(c)->contact != Contact::Connected) return OrderWords::tr("%1 does not answer now.").arg(c.name);
  return {};
}

}  // namespace

QString whyNotRun(const OrderCase& c) {
  if (QString no = unreachable(c); !no.isEmpty()) return no;
  if (viewIn(c)->state == wire::VehicleState::Faulted)
    return OrderWords::tr("A fault holds %1. Remove its cause and clear it first.").arg(c.name);
  if (viewIn(c)->state == wire::VehicleState::Calibrating)
    return OrderWords::tr("%1 calibrates its compass now.").arg(c.name);
  if (!c.siteHasRoutes) return OrderWords::tr("The site has no route yet. Draw one on the floor first.");
  if (c.route.isEmpty()) return OrderWords::tr("Choose a route first.");
  if (c.sameAsRunning) return OrderWords::tr("%1 runs this route already.").arg(c.name);
  return {};
}

QString whyNotPause(const OrderCase& c) {
  if (QString no = nobodyToTell(c); !no.isEmpty()) return no;
  if (viewIn(c)->task != Task::Running) return OrderWords::tr("%1 runs no route.").arg(c.name);
  return {};
}

QString whyNotResume(const OrderCase& c) {
  if (QString no = unreachable(c); !no.isEmpty()) return no;
  if (viewIn(c)->task != Task::Paused) return OrderWords::tr("%1 does not pause.").arg(c.name);
  if (viewIn(c)->state == wire::VehicleState::Faulted)
    return OrderWords::tr("A fault holds %1. Remove its cause and clear it first.").arg(c.name);
  return {};
}

QString whyNotStop(const OrderCase& c) { return nobodyToTell(c); }

QString whyNotClear(const OrderCase& c) {
  if (QString no = unreachable(c); !no.isEmpty()) return no;
  if (viewIn(c)->faults == 0 && viewIn(c)->state != wire::VehicleState::Faulted)
    return OrderWords::tr("%1 reports no fault.").arg(c.name);
  return {};
}

}  // namespace tessera::ui
