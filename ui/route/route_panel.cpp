#include "ui/route/route_panel.h"

#include <QAction>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "base/polyline.h"
#include "drive/driven_way.h"
#include "drive/travel_time.h"
#include "traffic/zone_map.h"
#include "ui/base/name_list.h"
#include "ui/base/place_table.h"
#include "ui/base/wording.h"

namespace tessera::ui {
namespace {

constexpr int kFirstSpacingKey = 2'000'000;
constexpr Seconds kUsualDelay{0.25};  // of commands to one of a few vehicles on a channel of their own

// At the speed that is asked for, and on legs that have one of their own no faster than that.
Seconds simpleTime(const floor::Route& route, MetresPerSecond speed) {
  Seconds time;
  for (std::size_t leg = 0; leg < floor::legCount(route); ++leg)
    time += distance(route.vertices[leg], route.vertices[leg + 1]) /
            std::min(speed, floor::legSpeed(route, leg).value_or(speed));
  return time;
}

}  // namespace

RoutePanel::RoutePanel(SiteDocument& document, Selection& selection, QWidget* parent)
    : QWidget{parent},
      document_{document},
      selection_{selection},
      edits_{document},
      vertices_{new VertexModel{document, this}},
      spacingKey_{kFirstSpacingKey} {
  setObjectName("routePanel");
  makeActions();
  pages_ = new QStackedWidget{this};
  pages_->addWidget(makeEmptyPage());
  pages_->addWidget(makeListPage());
  auto* layout = new QVBoxLayout{this};
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(pages_);
  connect(&document_, &SiteDocument::changed, this, &RoutePanel::refreshList);
  connect(&selection_, &Selection::routeChanged, this, [this] {
    ++spacingKey_;
    refreshList();
  });
  connect(&selection_, &Selection::vehicleChanged, this, &RoutePanel::refreshTime);
  connect(vertices_, &VertexModel::refused, this, &RoutePanel::refused);
  retranslate();
  refreshList();
}

void RoutePanel::refreshList() {
  QStringList names;
  for (const floor::Route& route : document_.site().routes) names << QString::fromStdString(route.name);
  const QString now = list_->setNames(names, selection_.route());
  pages_->setCurrentIndex(names.isEmpty() ? 0 : 1);
  selection_.setRoute(now);
  refreshDetails();
}

void RoutePanel::refreshDetails() {
  const floor::Route* route = edits_.find(selection_.route());
  const auto current = currentVertex();
  filling_ = true;
  vertices_->setRoute(selection_.route());
  details_->setEnabled(route != nullptr);
  for (QAction* action : {rename_, duplicate_, reverse_, delete_}) action->setEnabled(route != nullptr);
  if (route != nullptr) spacing_->setValue(route->controlSpacing.value());
  filling_ = false;
  if (current && *current < static_cast<std::size_t>(vertices_->rowCount()) && !currentVertex()) setVertex(current);
  refreshActions();
  refreshTime();
}

void RoutePanel::refreshTime() {
  const floor::Route* route = edits_.find(selection_.route());
  if (route == nullptr) {
    length_->setText({});
    return;
  }
  const QLocale locale;
  const MetresPerSecond speed{speed_->value()};
  const Metres way = Polyline{route->vertices}.length();
  Seconds time = simpleTime(*route, speed);
  const auto chosen = selection_.vehicle();
  const floor::VehicleSetup* vehicle = chosen ? document_.map()->vehicle(*chosen) : nullptr;
  if (vehicle != nullptr) {
    drive::SpeedPlanOptions plan;
    plan.requested = speed;
    const drive::VehicleAbility ability = drive::abilityOf(*vehicle);
    const auto zones = traffic::ZoneMap{document_.map()->site().zones}.slowStretches(
        drive::drivenWay(*route, ability, plan).line(), traffic::bodyBoxOf(*vehicle));
    time = drive::travelTime(*route, ability, plan, kUsualDelay, zones);
  }
  length_->setToolTip(
      vehicle != nullptr
          ? tr("As %1 drives it at that speed: with its ramps, its top speed, slow zones and its turns on the spot or "
               "arcs at corners.")
                .arg(QString::fromStdString(vehicle->name))
          : tr("Length divided by speed, slower on legs that have a lower one. Choose a vehicle for the time with its "
               "ramps and turns."));
  const double seconds = std::round(time.value());
  const QString metres = locale.toString(way.value(), 'f', 2);
  if (seconds < 100.0) {
    length_->setText(tr("%1 m, about %2 s").arg(metres, locale.toString(seconds, 'f', 0)));
  } else {
    length_->setText(tr("%1 m, about %2 min %3 s")
                         .arg(metres, locale.toString(std::floor(seconds / 60.0), 'f', 0),
                              locale.toString(std::fmod(seconds, 60.0), 'f', 0)));
  }
}

void RoutePanel::refreshActions() {
  const bool any = edits_.find(selection_.route()) != nullptr;
  const auto vertex = currentVertex();
  const auto count = static_cast<std::size_t>(vertices_->rowCount());
  insertVertex_->setEnabled(any);
  deleteVertex_->setEnabled(any && vertex && count > 2);
  split_->setEnabled(any && vertex && *vertex > 0 && *vertex + 1 < count);
  join_->menu()->clear();
  for (const QString& other : edits_.touching(selection_.route())) {
    QAction* action = join_->menu()->addAction(QString{other}.replace(QLatin1Char('&'), QLatin1String("&&")));
    connect(action, &QAction::triggered, this, [this, other] { tell(edits_.join(selection_.route(), other)); });
  }
  join_->setEnabled(!join_->menu()->isEmpty());
}

void RoutePanel::setVertex(std::optional<std::size_t> vertex) {
  if (vertex == currentVertex()) return;
  filling_ = true;
  table_->setPlace(vertex);
  filling_ = false;
  refreshActions();
}

std::optional<std::size_t> RoutePanel::currentVertex() const { return table_->place(); }

void RoutePanel::startRenaming() { list_->startRenaming(); }

void RoutePanel::insertVertex() {
  const floor::Route* route = edits_.find(selection_.route());
  if (route == nullptr) return;
  // Into the leg that begins at the current vertex; behind the last one half a metre straight on.
  const std::vector<Point>& all = route->vertices;
  const std::size_t at = std::min(currentVertex().value_or(all.size() - 1), all.size() - 1);
  Point place;
  if (at + 1 < all.size()) {
    place = all[at] + 0.5 * (all[at + 1] - all[at]);
  } else {
    const Offset leg = all[at] - all[at - 1];
    const double share = length(leg) > Metres{} ? 0.5 / length(leg).value() : 0.0;
    place = share > 0.0 ? all[at] + share * leg : all[at] + Offset{Metres{0.5}, Metres{}};
  }
  const auto done = edits_.insertVertex(selection_.route(), at + 1, tidy(place));
  tell(done);
  if (done) {
    setVertex(at + 1);
    Q_EMIT vertexSelected(at + 1);
  }
}

void RoutePanel::deleteVertex() {
  const auto vertex = currentVertex();
  if (!vertex) return;
  tell(edits_.removeVertex(selection_.route(), *vertex));
}

// By the button or the menu itself: only where there is no choice to make.
void RoutePanel::join() {
  const QStringList others = edits_.touching(selection_.route());
  if (others.size() == 1) tell(edits_.join(selection_.route(), others.front()));
}

void RoutePanel::split() {
  const auto vertex = currentVertex();
  if (!vertex) return;
  const auto rest = edits_.split(selection_.route(), *vertex);
  if (!rest) tell(tl::unexpected{rest.error()});
}

void RoutePanel::duplicate() {
  const auto copy = edits_.duplicate(selection_.route());
  if (!copy) return tell(tl::unexpected{copy.error()});
  selection_.setRoute(*copy);
  startRenaming();
}

void RoutePanel::tell(const Result<void>& result) {
  if (!result) Q_EMIT refused(text(result.error().sentence));
}

void RoutePanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange) {
    retranslate();
    vertices_->retranslate();
    refreshDetails();
  }
  QWidget::changeEvent(event);
}

}  // namespace tessera::ui
