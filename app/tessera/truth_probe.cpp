#include "app/tessera/truth_probe.h"

#include <QStringList>

namespace tessera::desktop {

TruthProbe::TruthProbe(FleetSession& session) : session_{session} {
  connect(&session_, &FleetSession::worldAnswered, this, &TruthProbe::hear);
}

void TruthProbe::ask(VehicleId vehicle) { session_.tellWorld("truth " + std::to_string(vehicle.value)); }

// Its clock is the supervision's: CLOCK_MONOTONIC of this machine.
void TruthProbe::hear(const QString& line) {
  const QStringList words = line.split(u' ');
  if (words.size() != 6 || words[0] != QLatin1String("truth")) return;
  bool good = true;
  const auto number = [&](qsizetype at) {
    bool read = false;
    const double value = words[at].toDouble(&read);
    good = good && read;
    return value;
  };
  const double id = number(1);
  ui::TruthSample sample;
  sample.at = Seconds{number(2)};
  sample.pose = {{Metres{number(3)}, Metres{number(4)}}, Radians{number(5)}};
  if (!good || id < 1 || id > 254) return;
  sample.vehicle = VehicleId{static_cast<std::uint8_t>(id)};
  Q_EMIT told(sample);
}

}  // namespace tessera::desktop
