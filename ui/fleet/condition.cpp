#include "ui/fleet/condition.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "ui/base/wording.h"

namespace tessera::ui {
namespace {

struct ConditionWords {
  Q_DECLARE_TR_FUNCTIONS(tessera::ui::Condition)
};

Condition whileConnected(const supervisor::VehicleView& v) {
  using supervisor::Task;
  if (v.state == wire::VehicleState::Faulted) return Condition::Faulted;
  if (v.task == Task::Jogging) return Condition::ByHand;
  if (v.task == Task::Paused) return Condition::Paused;
  if (v.task == Task::Running) return v.waits.empty() ? Condition::Running : Condition::Waiting;
  if (v.state == wire::VehicleState::Calibrating) return Condition::Calibrating;
  if (v.state == wire::VehicleState::Obstacle) return Condition::Obstacle;
  if (v.task == Task::Stopped) return Condition::Stopped;
  return v.task == Task::Finished ? Condition::Finished : Condition::Ready;
}

QString nextStep(Condition condition, const supervisor::VehicleView& v, const QString& name) {
  switch (condition) {
    case Condition::Calling:
      return ConditionWords::tr("%1 has not answered yet. Check that it is switched on and within reach of the radio.")
          .arg(name);
    case Condition::Silent:
      return ConditionWords::tr("%1 no longer answers. It stops by itself; check its power and the radio.").arg(name);
    case Condition::Refused:
      return ConditionWords::tr("%1 answers, but with another key or protocol version. Set it up again for this site.")
          .arg(name);
    case Condition::Obstacle:
      return ConditionWords::tr("%1 stands before an obstacle.").arg(name);
    case Condition::Calibrating:
      return ConditionWords::tr("%1 calibrates its compass.").arg(name);
    case Condition::ByHand:
      return ConditionWords::tr("%1 is driven by hand.").arg(name);
    case Condition::Paused:
      return ConditionWords::tr("%1 pauses. Resume lets it go on from here.").arg(name);
    case Condition::Finished:
      return ConditionWords::tr("%1 has reached the end of its route.").arg(name);
    case Condition::Stopped:
      if (v.located) return ConditionWords::tr("%1 was stopped. Run lets it drive again.").arg(name);
      break;
    case Condition::Ready:
      if (v.located) return ConditionWords::tr("%1 is ready. Choose a route and run it.").arg(name);
      break;
    default:
      return {};
  }
  return ConditionWords::tr("The place of %1 is not known. Put it where it reads tags.").arg(name);
}

}  // namespace

Condition conditionOf(const supervisor::Snapshot* snapshot, const supervisor::VehicleView* vehicle) {
  using supervisor::Contact;
  if (snapshot == nullptr || vehicle == nullptr || snapshot->port.state != supervisor::PortState::Open)
    return Condition::NoPort;
  switch (vehicle->contact) {
    case Contact::Calling:
      return Condition::Calling;
    case Contact::Silent:
      return Condition::Silent;
    case Contact::Refused:
      return Condition::Refused;
    case Contact::Connected:
      break;
  }
  return whileConnected(*vehicle);
}

QString words(Condition condition) {
  switch (condition) {
    case Condition::Faulted:
      return ConditionWords::tr("Fault");
    case Condition::Refused:
      return ConditionWords::tr("Refused");
    case Condition::Silent:
      return ConditionWords::tr("Silent");
    case Condition::Obstacle:
      return ConditionWords::tr("Obstacle");
    case Condition::Waiting:
      return ConditionWords::tr("Waiting");
    case Condition::NoPort:
      return ConditionWords::tr("Not connected");
    case Condition::Calling:
      return ConditionWords::tr("Calling");
    case Condition::Calibrating:
      return ConditionWords::tr("Calibrating");
    case Condition::Paused:
      return ConditionWords::tr("Paused");
    case Condition::Running:
      return ConditionWords::tr("Running");
    case Condition::ByHand:
      return ConditionWords::tr("By hand", "driven by keys");
    case Condition::Stopped:
      return ConditionWords::tr("Stopped");
    case Condition::Ready:
      return ConditionWords::tr("Ready");
    case Condition::Finished:
      return ConditionWords::tr("Arrived");
  }
  return {};
}

QString iconName(Condition condition) {
  switch (condition) {
    case Condition::Faulted:
      return QStringLiteral("error");
    case Condition::Refused:
      return QStringLiteral("lock");
    case Condition::Silent:
      return QStringLiteral("silent");
    case Condition::Obstacle:
      return QStringLiteral("obstacle");
    case Condition::Waiting:
      return QStringLiteral("waiting");
    case Condition::NoPort:
      return QStringLiteral("disconnect");
    case Condition::Calling:
      return QStringLiteral("radio");
    case Condition::Calibrating:
      return QStringLiteral("compass");
    case Condition::Paused:
      return QStringLiteral("pause");
    case Condition::Running:
      return QStringLiteral("run");
    case Condition::ByHand:
      return QStringLiteral("jog");
    case Condition::Stopped:
      return QStringLiteral("stop");
    case Condition::Ready:
      return QStringLiteral("link-good");
    case Condition::Finished:
      return QStringLiteral("check");
  }
  return {};
}

Tone toneOf(Condition condition) {
  switch (condition) {
    case Condition::Faulted:
    case Condition::Refused:
    case Condition::Silent:
      return Tone::Bad;
    case Condition::Obstacle:
    case Condition::Waiting:
    case Condition::Paused:
      return Tone::Warning;
    case Condition::NoPort:
    case Condition::Calling:
      return Tone::Quiet;
    case Condition::Running:
    case Condition::ByHand:
    case Condition::Calibrating:
      return Tone::Busy;
    case Condition::Ready:
    case Condition::Finished:
      return Tone::Good;
    case Condition::Stopped:
      break;
  }
  return Tone::Plain;
}

QString situation(const supervisor::Snapshot* snapshot, const supervisor::VehicleView* vehicle, const QString& name) {
  const Condition condition = conditionOf(snapshot, vehicle);
  if (condition == Condition::NoPort) {
    const QString port = snapshot == nullptr ? QString{} : text(snapshot->port.sentence);
    return port.isEmpty() ? ConditionWords::tr("There is no connection to the vehicles. Connect first.") : port;
  }
  if (condition == Condition::Faulted)
    return ConditionWords::tr("%1 is held by a fault (%2). Remove the cause, then clear the fault.")
        .arg(name, faultTexts(vehicle->faults).join(ConditionWords::tr(", ", "between faults")));
  if (!vehicle->waits.empty()) return text(vehicle->waits);
  if (const QString next = nextStep(condition, *vehicle, name); !next.isEmpty()) return next;
  const QString doing = text(vehicle->doing);
  return doing.isEmpty()
             ? ConditionWords::tr("%1 drives along the route %2.").arg(name, QString::fromStdString(vehicle->route))
             : doing;
}

Metres placeUncertainty(const supervisor::VehicleView& vehicle) {
  const double xx = vehicle.covariance[0];
  const double xy = vehicle.covariance[1];
  const double yy = vehicle.covariance[4];
  const double largest = (xx + yy) / 2.0 + std::hypot((xx - yy) / 2.0, xy);
  return Metres{2.4477 * std::sqrt(std::max(0.0, largest))};  // 95 % of a distribution in the plane
}

}  // namespace tessera::ui
