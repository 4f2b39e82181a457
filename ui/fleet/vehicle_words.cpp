// What the rows of the vehicle list say: texts, icons and tooltips of VehicleModel.
#include <QLocale>
#include <algorithm>

#include "ui/fleet/vehicle_model.h"

namespace tessera::ui {

QVariant VehicleModel::shown(const Row& row, int column) const {
  const QLocale locale;
  const auto number = [&](int value, double unit, int decimals) {
    return locale.toString(value * unit, 'f', decimals);
  };
  const QString nothing = QStringLiteral("–");
  switch (column) {
    case Name:
      return row.name;
    case State:
      return words(row.condition);
    case Progress:
      return row.permille == kUnknown ? nothing : tr("%1 %").arg(number(row.permille / 10, 1.0, 0));
    case RouteName:
      return row.route.empty() ? nothing : QString::fromStdString(row.route);
    case Speed:
      return row.speed == kUnknown ? nothing : tr("%1 m/s").arg(number(row.speed, 0.01, 2));
    case Battery:
      return row.battery == kUnknown ? nothing : tr("%1 V").arg(number(row.battery, 0.1, 1));
    case Link:
      return row.loss == kUnknown ? nothing : tr("%1 % lost").arg(number(row.loss, 1.0, 0));
    case Age:
      if (row.age == kUnknown) return nothing;
      return row.age < 100 ? tr("%1 s").arg(number(row.age, 0.1, 1)) : tr("%1 s").arg(number(row.age / 10, 1.0, 0));
    case Place:
      if (row.age == kUnknown) return nothing;
      return row.uncertainty == kUnknown ? tr("unknown") : tr("± %1 cm").arg(number(row.uncertainty, 0.1, 1));
    default:
      return {};
  }
}

QVariant VehicleModel::sortKey(const Row& row, int column) const {
  switch (column) {
    case Name:
      return row.name;
    case State:
      return static_cast<int>(row.condition);
    case Progress:
      return row.permille;
    case RouteName:
      return QString::fromStdString(row.route);
    case Speed:
      return row.speed;
    case Battery:
      return row.battery;
    case Link:
      return row.loss;
    case Age:
      return row.age == kUnknown ? std::numeric_limits<int>::max() : row.age;
    case Place:
      return row.uncertainty == kUnknown ? std::numeric_limits<int>::max() : row.uncertainty;
    default:
      return {};
  }
}

QString VehicleModel::iconOf(const Row& row, int column) const {
  if (column == State) return iconName(row.condition);
  if (column == Battery && row.battery != kUnknown)
    return (row.faults & wire::kFaultBattery) != 0 ? QStringLiteral("battery-low") : QStringLiteral("battery-full");
  if (column == Link && row.loss != kUnknown) {
    if (row.loss < 10) return QStringLiteral("link-good");
    return row.loss < 40 ? QStringLiteral("link-fair") : QStringLiteral("link-bad");
  }
  return {};
}

Tone VehicleModel::toneFor(const Row& row, int column) {
  const bool heard = row.age != kUnknown;
  switch (column) {
    case State:
      return toneOf(row.condition);
    case Battery:
      return heard && (row.faults & wire::kFaultBattery) != 0 ? Tone::Bad : Tone::Plain;
    case Link:
      if (!heard || row.loss < 10) return Tone::Plain;
      return row.loss < 40 ? Tone::Warning : Tone::Bad;
    case Age:
      if (!heard || row.age < 10) return Tone::Plain;
      return row.age < 30 ? Tone::Warning : Tone::Bad;
    case Place:
      return heard && row.uncertainty == kUnknown ? Tone::Warning : Tone::Plain;
    default:
      return Tone::Plain;
  }
}

QString VehicleModel::tip(const Row& row, int column) const {
  const supervisor::VehicleView* view = viewOf(row.id);
  const QLocale locale;
  switch (column) {
    case Name:
      return view == nullptr || view->firmware.empty() ? tr("%1, address %2").arg(row.name).arg(row.id.value)
                                                       : tr("%1, address %2, firmware %3")
                                                             .arg(row.name)
                                                             .arg(row.id.value)
                                                             .arg(QString::fromStdString(view->firmware));
    case State:
      return situation(snapshot_.get(), view, row.name);
    case Battery:
      return (row.faults & wire::kFaultBattery) != 0 ? tr("The battery is low. Charge it soon.")
                                                     : tr("Voltage of the battery.");
    case Link:
      if (view == nullptr || row.loss == kUnknown) return tr("No answer has come yet.");
      return tr("%1 % of the last calls stayed without an answer. There and back takes %2 ms. Restarts seen: %3.")
          .arg(locale.toString(row.loss), locale.toString(1000.0 * view->link.roundTrip.value(), 'f', 0),
               locale.toString(view->link.restarts));
    case Age:
      return row.age == kUnknown ? tr("No answer has come yet.") : tr("Time since its last answer.");
    case Place:
      return row.uncertainty == kUnknown ? tr("Its place is not known. Put it where it reads tags.")
                                         : tr("Where it is, is known to this much with a probability of 95 %.");
    case Progress:
      if (view == nullptr || row.permille == kUnknown) return tr("It has no route now.");
      return tr("%1 m of %2 m")
          .arg(locale.toString(view->progress.value(), 'f', 1), locale.toString(view->length.value(), 'f', 1));
    default:
      return {};
  }
}

QVariant VehicleModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case Name:
      return tr("Vehicle");
    case State:
      return tr("State");
    case Progress:
      return tr("Progress");
    case RouteName:
      return tr("Route");
    case Speed:
      return tr("Speed");
    case Battery:
      return tr("Battery");
    case Link:
      return tr("Link");
    case Age:
      return tr("Data age");
    case Place:
      return tr("Place");
    default:
      return {};
  }
}

}  // namespace tessera::ui
