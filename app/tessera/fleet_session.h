// One supervision after the other, as the window asks for them: the port or the simulated world, the supervisor's
// thread, and an orderly end in which the vehicles stop first.
#pragma once

#include <QStringList>
#include <QTimer>
#include <map>
#include <memory>
#include <optional>

#include "app/process/world_process.h"
#include "app/tessera/offered_keys.h"
#include "host/port_choice.h"
#include "host/supervisor_thread.h"
#include "ui/base/connection_choice.h"
#include "ui/base/fleet_link.h"

class QTemporaryDir;

namespace tessera::desktop {

/// Where this choice leads; `port` stands for the simulated world's, `baud` for the site's.
[[nodiscard]] host::PortChoice portChoiceOf(const ui::ConnectionChoice& choice, const QString& port, int baud);

class FleetSession : public ui::FleetLink {
  Q_OBJECT
public:
  enum class State {
    Off,
    Starting,  ///< the simulated world is being set up
    Live,      ///< a supervisor works; what its port does stands in the snapshot
    Resting,   ///< somebody else uses the port
    Stopping,  ///< the vehicles are being stopped
  };

  explicit FleetSession(QObject* parent = nullptr);
  /// Ends everything, the vehicles first.
  ~FleetSession() override;

  [[nodiscard]] std::shared_ptr<const supervisor::Snapshot> latest() const override;
  /// A Pair's key is kept first. While supervision ends, orders to stop are taken alone.
  bool post(supervisor::Order order) override;

  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] const std::optional<ui::ConnectionChoice>& choice() const { return choice_; }
  /// Ends what runs, then supervises the site's vehicles; with a site that contradicts itself none, which is told.
  void connectTo(const ui::ConnectionChoice& choice, std::shared_ptr<const floor::SiteMap> map);
  /// The vehicles stop, then the port closes and the state is Off.
  void disconnectGently();
  /// The same at once, in some seconds at most. Names of the vehicles that have not confirmed that they stand.
  QStringList close();
  /// The site was edited: a running supervision goes on with it, or begins anew where vehicles or radio differ.
  /// If it contradicts itself now, the vehicles stop.
  void useSite(std::shared_ptr<const floor::SiteMap> map);

  /// Lets the port go for a while, the vehicles stopped, and says which it is; nullopt: there was none.
  std::optional<host::PortChoice> rest();
  /// Goes on after rest().
  void resume();
  /// The key that a vehicle was offered and that its site does not have yet.
  [[nodiscard]] std::optional<wire::Key> offeredKey(VehicleId vehicle) const;
  /// A file has this site, and the keys of its vehicles with it.
  void keysAreFiled(const floor::Site& site) { keys_.forget(site); }
  /// How long the present supervision works.
  [[nodiscard]] Seconds liveFor() const;

  /// Vehicles in an emulated microcontroller instead of compiled for this machine; for the next demo.
  void setEmulated(bool emulated) { emulated_ = emulated; }
  [[nodiscard]] bool hasWorld() const { return world_ != nullptr && state_ == State::Live; }
  /// A line for the simulated world; nothing without one.
  void tellWorld(const std::string& line);

Q_SIGNALS:
  void stateChanged();
  /// Its answer to what tellWorld() said.
  void worldAnswered(const QString& line);
  /// The simulated world's own line, in English: that the machine does not keep up, that a vehicle has ended.
  void worldComplained(const QString& line);
  /// A complete sentence.
  void failed(const QString& sentence);

private:
  void setState(State state);
  void startWorld();
  void supervise(const host::PortChoice& port);
  [[nodiscard]] bool refuses(const floor::SiteMap& map);
  void beginEnd();
  void endThread();
  void finish();
  void passSiteOn();
  void onWorldDied(const QString& sentence);
  void lookWhetherStopped();
  [[nodiscard]] bool allStand() const;
  [[nodiscard]] QStringList unconfirmed(bool stood) const;
  [[nodiscard]] bool goesOnWith(const floor::Site& site) const;

  State state_ = State::Off;
  std::optional<ui::ConnectionChoice> choice_;
  std::optional<ui::ConnectionChoice> next_;  // connects when the present one has ended
  std::shared_ptr<const floor::SiteMap> map_;
  bool outdated_ = false;  // what runs is of vehicles that the site no longer has
  OfferedKeys keys_;
  std::map<VehicleId, wire::Key> offered_;  // keys that vehicles were offered until and during this supervision
  bool emulated_ = false;
  std::unique_ptr<QTemporaryDir> folder_;  // the site's file for the simulated world
  std::unique_ptr<process::WorldProcess> world_;
  std::unique_ptr<host::SupervisorThread> thread_;
  std::optional<host::PortChoice> port_;  // while it is open, or rests
  Seconds since_;
  QTimer editing_;  // edits of one drag reach the supervision together
  QTimer stopping_;
  int patience_ = 0;
};

}  // namespace tessera::desktop
