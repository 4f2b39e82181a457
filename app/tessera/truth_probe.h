// Asks the simulated world where a vehicle truly is, past the supervision: for the view that judges the locating.
#pragma once

#include "app/tessera/fleet_session.h"
#include "ui/locating/truth_source.h"

namespace tessera::desktop {

class TruthProbe : public ui::TruthSource {
  Q_OBJECT
public:
  /// session must outlive it.
  explicit TruthProbe(FleetSession& session);
  [[nodiscard]] bool isThere() const override { return session_.hasWorld(); }
  void ask(VehicleId vehicle) override;

private:
  void hear(const QString& line);

  FleetSession& session_;
};

}  // namespace tessera::desktop
