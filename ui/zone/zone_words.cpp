#include "ui/zone/zone_words.h"

#include <QCoreApplication>

namespace tessera::ui {
namespace {

struct ZoneWords {
  Q_DECLARE_TR_FUNCTIONS(ZoneWords)
};

}  // namespace

QString zoneKindName(floor::ZoneKind kind) {
  using floor::ZoneKind;
  switch (kind) {
    case ZoneKind::Running:
      return ZoneWords::tr("Running zone");
    case ZoneKind::Storage:
      return ZoneWords::tr("Storage zone");
    case ZoneKind::Parking:
      return ZoneWords::tr("Parking zone");
    case ZoneKind::Charging:
      return ZoneWords::tr("Charging zone");
    case ZoneKind::NoGo:
      return ZoneWords::tr("No-go zone");
    case ZoneKind::Slow:
      return ZoneWords::tr("Slow zone");
    case ZoneKind::OneWay:
      return ZoneWords::tr("One-way zone");
    case ZoneKind::SingleVehicle:
      return ZoneWords::tr("Single-vehicle zone");
  }
  return {};
}

QString zoneKindMeaning(floor::ZoneKind kind) {
  using floor::ZoneKind;
  switch (kind) {
    case ZoneKind::Running:
      return ZoneWords::tr("Vehicles may drive here.");
    case ZoneKind::Storage:
      return ZoneWords::tr("Vehicles may be here; goods are put down and taken up.");
    case ZoneKind::Parking:
      return ZoneWords::tr("Vehicles may be here; idle ones wait.");
    case ZoneKind::Charging:
      return ZoneWords::tr("Vehicles may be here; they charge their batteries.");
    case ZoneKind::NoGo:
      return ZoneWords::tr("No vehicle may be here, whatever other zones say.");
    case ZoneKind::Slow:
      return ZoneWords::tr("Vehicles drive no faster than the zone's speed here.");
    case ZoneKind::OneWay:
      return ZoneWords::tr("Ways lead within 90° of the zone's direction here.");
    case ZoneKind::SingleVehicle:
      return ZoneWords::tr("Only one vehicle at a time may be here.");
  }
  return {};
}

QString zoneStackingRules() {
  return ZoneWords::tr(
      "Zones upon one another:\n"
      "• No-go wins over every other kind.\n"
      "• A vehicle may be where a running, storage, parking or charging zone is and no no-go zone; the other kinds "
      "restrict what lies under them.\n"
      "• Of several slow zones the lowest speed holds.\n"
      "• Of several one-way zones each holds.\n"
      "• Of several single-vehicle zones each has to be free.");
}

}  // namespace tessera::ui
