// One vehicle in the supervisor's eyes: what the channel tells of it goes in, what it shall do comes out. It owns the
// vehicle's locator and follower and knows why the vehicle waits.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "drive/route_follower.h"
#include "floor/site_map.h"
#include "link/link_event.h"
#include "link/peer.h"
#include "locate/locator.h"
#include "locate/magnetic_learner.h"
#include "supervisor/command_history.h"
#include "supervisor/episode.h"
#include "supervisor/event_log.h"
#include "supervisor/expectation.h"
#include "supervisor/hand_drive.h"
#include "supervisor/locating_view.h"
#include "supervisor/odometer.h"
#include "supervisor/order.h"
#include "supervisor/sentences.h"
#include "supervisor/snapshot.h"
#include "traffic/zone_guard.h"

namespace tessera::supervisor {

/// What the agent needs to know of the channel when it decides.
struct ChannelTiming {
  Seconds effectiveAt{};  ///< when a command that is sent now takes effect
  Seconds cycle;          ///< time between two commands
};

/// Of the radio's delay, what the measured mean does not tell.
inline constexpr Seconds kUnpredictedDelay{0.01};

class VehicleAgent {
public:
  /// Error: an unknown locator or controller.
  [[nodiscard]] static Result<VehicleAgent> create(std::shared_ptr<const floor::SiteMap> map,
                                                   const floor::VehicleSetup& setup, const std::string& locator,
                                                   const std::string& controller,
                                                   std::shared_ptr<traffic::Traffic> traffic);

  [[nodiscard]] VehicleId id() const { return setup_.id; }
  [[nodiscard]] const Sentence& name() const { return name_; }

  // Orders. What cannot be carried out is told as OrderRefused.
  void run(const RunRoute& order, EventLog& log);
  void pause(EventLog& log);
  void resume(EventLog& log);
  void stop(EventLog& log);
  void clear() { clearing_ = true; }
  void jog(const Jog& order, EventLog& log);
  /// True: the vehicle may be asked to move by itself (to calibrate its compass); a Stop does not hold it any longer.
  [[nodiscard]] bool letGo(EventLog& log);
  /// True: it may be given another key now.
  [[nodiscard]] bool mayBePaired(EventLog& log) const;
  /// Somebody looks at how it is located, or no longer does.
  void watch(bool watched);
  /// The floor's magnetic map, which outlives this and is not changed while it is told anything. byIt: the vehicle is
  /// located by it as well. Null: there is none.
  void useMagneticMap(std::shared_ptr<const locate::MagneticMap> map, bool byIt);
  /// What its compass has taught since; to be called when nobody reads the map. True: something.
  bool teach(locate::MagneticMap& map) { return learner_.teach(map); }
  /// Its settings change or its compass is calibrated: what was learned of it may no longer hold.
  void forgetCompass() { learner_.restart(); }
  /// The site was edited; the vehicle itself is what it was.
  void use(std::shared_ptr<const floor::SiteMap> map);
  /// The zones of the traffic that it shares are others now.
  void useTraffic();

  // What the channel tells of this vehicle.
  void take(const link::Identified& e, EventLog& log);
  void take(const link::WrongKey& e, EventLog& log);
  void take(const link::WrongVersion& e, EventLog& log);
  void take(const link::Restarted& e, EventLog& log);
  void take(const link::Silent& e, Seconds now, EventLog& log);
  void take(const link::BackAgain& e, EventLog& log);
  void take(const link::Reported& e, EventLog& log);
  void take(const link::CommandSent& e);
  void take(const link::CommandAcknowledged& e);
  void take(const link::CommandUnanswered& e) { history_.unanswered(e.counter); }
  /// inSession: one stands now. The old ones end with the old key.
  void take(const link::PairingEnded& e, bool inSession, EventLog& log);
  void take(const link::Disbelieved& e, Seconds now, EventLog& log);

  /// Decides what the vehicle shall do, as of `now`, and ends episodes that are over.
  [[nodiscard]] link::Wish decide(Seconds now, const ChannelTiming& timing, EventLog& log);
  [[nodiscard]] VehicleView view(Seconds now, const PortView& port, const link::LinkQuality& quality) const;
  /// Null: nobody watches it, or it has not reported yet.
  [[nodiscard]] std::shared_ptr<const LocatingView> locatingView() const;
  /// It stands by an acknowledged Stop, or is not in touch, in which case it stops by itself.
  [[nodiscard]] bool stopped() const;

private:
  VehicleAgent(std::shared_ptr<const floor::SiteMap> map, floor::VehicleSetup setup,
               std::shared_ptr<traffic::Traffic> traffic);
  void takeName();
  void refuse(EventLog& log, const Sentence& why) const;
  void inTouch(EventLog& log);
  void takeTags(const link::Reported& e, EventLog& log);
  void tellSilence(const link::Reported& e);
  /// gap: what came since it was last told may be missing.
  void tellSilence(Seconds until, bool gap);
  void foresee();
  void noteInnovation(const ReadView& read);
  void watchState(Seconds now, EventLog& log);
  void watchPlace(EventLog& log);
  [[nodiscard]] Radians reportedHeading() const;
  [[nodiscard]] drive::VehicleState state() const;
  [[nodiscard]] Expectation expectedAt(Seconds until) const;
  /// It last told that it stands, or brakes, of its own accord: before an obstacle, with a fault, for its compass.
  [[nodiscard]] bool isHeld() const;
  void follow(Seconds now, const ChannelTiming& timing, EventLog& log);
  [[nodiscard]] link::Wish wishFor(const ChannelTiming& timing) const;
  void watchZones();
  [[nodiscard]] Sentence zoneWait() const;
  [[nodiscard]] Sentence waitReason(Seconds now, const PortView& port) const;
  [[nodiscard]] std::optional<CommandView> commandView(Seconds now) const;

  std::shared_ptr<const floor::SiteMap> map_;
  floor::VehicleSetup setup_;
  Sentence name_;
  std::string locatorName_;
  std::string controller_;
  drive::VehicleAbility ability_;
  std::unique_ptr<locate::Locator> locator_;
  std::shared_ptr<const locate::MagneticMap> magnetic_;
  bool byMagnetic_ = false;
  locate::MagneticLearner learner_;
  std::unique_ptr<drive::RouteFollower> follower_;
  std::shared_ptr<traffic::Traffic> traffic_;
  std::shared_ptr<traffic::ZoneGuard> guard_;  ///< of the follower
  traffic::BodyBox body_;
  std::optional<Pose> under_;  ///< for which the traffic knows in which zones it is
  std::string routeName_;
  HandDrive hand_;

  Task task_ = Task::None;
  Contact contact_ = Contact::Calling;
  bool clearing_ = false;
  Sentence firmware_;
  std::optional<link::Reported> last_;
  locate::Estimate estimate_;             ///< at the last report
  std::optional<locate::Motion> motion_;  ///< of the last report
  RadiansPerSecond turnRate_;             ///< then
  Odometer odometer_;
  CommandHistory history_;
  std::optional<drive::Decision> decision_;
  std::optional<drive::Command> wished_;  ///< what a Drive that leaves now says
  Pose predicted_;
  Seconds toldUntil_;  ///< every tag event before has been passed to the locator
  std::uint32_t reads_ = 0;
  std::vector<ReadView> recentReads_;
  bool watched_ = false;
  ChannelTiming timing_;  ///< of the last decision
  std::vector<locate::Innovation> innovations_;

  struct Sent {
    CommandView view;
    std::uint32_t counter = 0;
    Seconds effectiveAt;
  };
  std::optional<Sent> sent_;

  Episode wrongKey_;
  Episode wrongVersion_;
  Episode silent_;
  Episode restart_;
  Episode obstacle_;
  Episode expired_;
  Episode lost_;
  Episode doubted_{Seconds{1.0}};
  Episode forged_{Seconds{5.0}};
  Episode replayed_{Seconds{5.0}};
  Episode strange_{Seconds{5.0}};
  Episode byHand_{Seconds{3.0}};
  Episode jogRefused_{Seconds{1.0}};
  std::vector<Episode> faults_;  ///< in the order of faultTexts()
  std::set<floor::TagUid> unknownTags_;
  bool everLocated_ = false;
};

}  // namespace tessera::supervisor
