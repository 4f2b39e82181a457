#include "app/tessera/demo_drive.h"

#include <QDir>
#include <QPixmap>
#include <chrono>
#include <utility>

#include "app/tessera/fleet_session.h"
#include "app/tessera/main_window.h"
#include "ui/canvas/floor_canvas.h"

namespace tessera::desktop {

DemoDrive::DemoDrive(MainWindow& window, Plan plan) : QObject{&window}, window_{window}, plan_{std::move(plan)} {
  connect(&window_.session(), &ui::FleetLink::snapshotChanged, this, &DemoDrive::look);
  connect(&window_.session(), &FleetSession::failed, this, &DemoDrive::end);
  limit_.setSingleShot(true);
  connect(&limit_, &QTimer::timeout, this,
          [this] { end(QStringLiteral("The route was not finished within %1 s.").arg(plan_.limitS)); });
  if (plan_.untilFinished) limit_.start(std::chrono::seconds{plan_.limitS});
}

void DemoDrive::look() {
  const auto snapshot = window_.session().latest();
  if (!snapshot || ended_) return;
  if (!vehicle_) {
    order(*snapshot);
  } else if (const auto* view = snapshot->find(*vehicle_); view != nullptr && view->finished) {
    end({});
  }
}

void DemoDrive::order(const supervisor::Snapshot& snapshot) {
  for (const auto& view : snapshot.vehicles) {
    if (view.contact != supervisor::Contact::Connected || !view.located) continue;
    const auto& routes = window_.document().site().routes;
    if (plan_.route.isEmpty() && !routes.empty()) plan_.route = QString::fromStdString(routes.front().name);
    if (window_.document().map()->route(plan_.route.toStdString()) == nullptr) {
      end(QStringLiteral("The site has no route called “%1”.").arg(plan_.route));
      return;
    }
    if (!window_.session().post(supervisor::RunRoute{view.id, plan_.route.toStdString(), plan_.speed})) return;
    vehicle_ = view.id;
    window_.selection().setVehicle(view.id);
    window_.selection().setRoute(plan_.route);
    return;
  }
}

void DemoDrive::end(QString failure) {
  if (std::exchange(ended_, true) || !plan_.untilFinished) return;
  if (!plan_.folder.isEmpty()) {
    window_.canvas().finishDrawing();
    const QString picture = QDir{plan_.folder}.filePath(QStringLiteral("window.png"));
    if ((!QDir{}.mkpath(plan_.folder) || !window_.grab().save(picture)) && failure.isEmpty())
      failure = QStringLiteral("The picture %1 could not be written.").arg(picture);
  }
  Q_EMIT ended(failure);
}

}  // namespace tessera::desktop
