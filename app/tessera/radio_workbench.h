// The host's own radio module between the dialogue and the port. While this lives the supervision rests, its vehicles
// stopped; afterwards it goes on.
#pragma once

#include <QStringList>
#include <memory>
#include <optional>

#include "app/tessera/fleet_session.h"
#include "host/radio_module.h"
#include "link/radio_advice.h"
#include "ui/base/radio_bench.h"

namespace tessera::desktop {

class RadioWorkbench : public ui::RadioBench {
  Q_OBJECT
public:
  /// The port is the session's where it has one, else the choice's.
  RadioWorkbench(FleetSession& session, const ui::ConnectionChoice& choice, const floor::RadioSetup& site);
  ~RadioWorkbench() override;

  void read() override;
  void write(const link::E32Parameters& parameters) override;
  void cancel() override;

  /// What to do about module, site and vehicles that do not hear each other; whole sentences, in order.
  [[nodiscard]] QStringList advice() const;

private:
  void look(const supervisor::Snapshot* snapshot);

  FleetSession& session_;
  bool simulated_;
  std::unique_ptr<host::RadioModule> module_;
  link::RadioFindings findings_;
  bool writing_ = false;  ///< the next parameters found are new ones
};

}  // namespace tessera::desktop
