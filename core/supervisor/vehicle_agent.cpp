// Decisions and the picture; orders are taken in vehicle_agent_orders.cpp, what the channel tells in
// vehicle_agent_link.cpp.
#include "supervisor/vehicle_agent.h"

#include <algorithm>
#include <cmath>

#include "floor/bearing.h"

namespace tessera::supervisor {
namespace {

constexpr Seconds kShortestExpiry{0.4};
constexpr Seconds kLongestExpiry{5.1};
constexpr double kExpiryCycles = 3.0;
constexpr MetresPerSecond kStanding{0.005};
constexpr RadiansPerSecond kStandingTurn{0.1};  // the compass is noisy

}  // namespace

VehicleAgent::VehicleAgent(std::shared_ptr<const floor::SiteMap> map, floor::VehicleSetup setup,
                           std::shared_ptr<traffic::Traffic> traffic)
    : map_{std::move(map)},
      setup_{std::move(setup)},
      ability_{drive::abilityOf(setup_)},
      traffic_{std::move(traffic)},
      body_{traffic::bodyBoxOf(setup_)},
      hand_{ability_} {
  takeName();
  for (const FaultText& text : faultTexts()) faults_.emplace_back(text.quiet);
}

void VehicleAgent::takeName() { name_ = vehicleName(setup_); }

Result<VehicleAgent> VehicleAgent::create(std::shared_ptr<const floor::SiteMap> map, const floor::VehicleSetup& setup,
                                          const std::string& locator, const std::string& controller,
                                          std::shared_ptr<traffic::Traffic> traffic) {
  VehicleAgent agent{map, setup, std::move(traffic)};
  agent.locatorName_ = locator.empty() ? locate::locatorNames().front() : std::string_view{locator};
  auto made = locate::makeLocator(agent.locatorName_, map, setup);
  if (!made) return tl::unexpected{made.error()};
  agent.locator_ = std::move(*made);
  agent.estimate_ = agent.locator_->at(agent.locator_->lastMotion());
  const auto known = drive::followerNames();
  agent.controller_ = controller.empty() ? std::string{known.front()} : controller;
  if (std::find(known.begin(), known.end(), agent.controller_) == known.end())
    return failure("There is no controller called \"" + controller + "\".");
  return agent;
}

bool VehicleAgent::stopped() const {
  if (contact_ != Contact::Connected) return true;
  if (task_ == Task::Running || task_ == Task::Jogging || !last_ || !sent_ ||
      sent_->view.mode != wire::CommandMode::Stop)
    return false;
  const wire::VehicleState state = last_->report.state;
  const bool moves = state == wire::VehicleState::Driving || state == wire::VehicleState::Turning;
  return !moves && sent_->view.status == CommandStatus::Acknowledged && last_->report.speed == 0;
}

// --- decisions
// --------------------------------------------------------------------------------------------------------

Radians VehicleAgent::reportedHeading() const {
  return floor::headingOfBearing(floor::fromBinaryAngle(last_->report.bearing), map_->site().northToY);
}

drive::VehicleState VehicleAgent::state() const {
  return {estimate_.at,
          estimate_.pose,
          estimate_.speed,
          turnRate_,
          estimate_.positionSigma(),
          estimate_.located,
          Radians{std::sqrt(std::max(0.0, estimate_.covariance(2, 2)))},
          last_ && last_->report.state == wire::VehicleState::Turning};
}

bool VehicleAgent::isHeld() const {
  using enum wire::VehicleState;
  return last_ &&
         (last_->report.state == Obstacle || last_->report.state == Faulted || last_->report.state == Calibrating);
}

// A vehicle that stands and is told nothing is where it was; most of a large fleet is, most of the time. One that holds
// itself obeys nothing, whatever is under way.
Expectation VehicleAgent::expectedAt(Seconds until) const {
  drive::VehicleState known = state();
  if (isHeld()) return {drive::predict(known, {}, until, ability_)};
  if (history_.holdsAfter(known.at) || abs(known.speed) > kStanding || abs(known.turnRate) > kStandingTurn)
    return expectedOver(known, history_.cases(), until, ability_);
  known.at = std::max(known.at, until);
  return {known};
}

link::Wish VehicleAgent::decide(Seconds now, const ChannelTiming& timing, EventLog& log) {
  const auto end = [&](Episode& episode, EventKind kind, Pattern over) {
    if (episode.notSeen(now) == Episode::Change::Ends)
      log.tell(Severity::Info, kind, id(), over.with(name_, episode.count()), true);
  };
  end(forged_, EventKind::ForgedFrames, phrase("Core", "No more forged frames in the name of %1; %2 were dropped."));
  end(replayed_, EventKind::ReplayedFrames,
      phrase("Core", "No more replayed frames in the name of %1; %2 were dropped."));
  end(strange_, EventKind::StrangeFrames,
      phrase("Core", "No more senseless frames in the name of %1; %2 were dropped."));
  if (task_ == Task::Jogging && !hand_.holds(now)) task_ = Task::Stopped;
  if (byHand_.update(task_ == Task::Jogging, now) == Episode::Change::Ends)
    log.tell(Severity::Info, EventKind::DrivenByHand, id(),
             phrase("Core", "%1 is no longer driven by hand.").with(name_), true);
  watchZones();
  follow(now, timing, log);
  return wishFor(timing);
}

void VehicleAgent::follow(Seconds now, const ChannelTiming& timing, EventLog& log) {
  timing_ = timing;
  const drive::VehicleState expected = expectedAt(timing.effectiveAt).state;
  predicted_ = expected.pose;
  if (contact_ != Contact::Connected || !last_) return;
  if (task_ == Task::Jogging) wished_ = hand_.command(expected.pose.heading, timing.cycle);
  if (task_ != Task::Running || !follower_) return;
  const drive::VehicleState& given = follower_->wantsPrediction() ? expected : state();
  decision_ = follower_->decide({given, timing.cycle + kUnpredictedDelay}, now);
  wished_ = decision_->command;
  if (decision_->phase != drive::Phase::Finished || abs(estimate_.speed) > kStanding) return;
  task_ = Task::Finished;
  log.tell(Severity::Info, EventKind::RouteFinished, id(),
           phrase("Core", "%1 has reached the end of the route %2.").with(name_, routeName_));
}

link::Wish VehicleAgent::wishFor(const ChannelTiming& timing) const {
  link::Wish wish;
  if (clearing_) {
    wish.mode = wire::CommandMode::Clear;
  } else if (task_ == Task::None) {
    wish.mode = wire::CommandMode::Poll;
  } else if (!wished_ || !(task_ == Task::Jogging || (task_ == Task::Running && estimate_.located))) {
    wish.mode = wire::CommandMode::Stop;
  } else {
    wish.mode = wire::CommandMode::Drive;
    wish.speed = wished_->speed;
    // The vehicle holds a heading by its own compass, whose bias the locator has learned.
    const Radians shown = wished_->heading + estimate_.headingBias;
    wish.bearing = floor::toBinaryAngle(floor::bearingOfHeading(shown, map_->site().northToY));
    wish.expiry = std::clamp(kExpiryCycles * timing.cycle, kShortestExpiry, kLongestExpiry);
  }
  return wish;
}

// --- the picture
// ------------------------------------------------------------------------------------------------------

std::optional<CommandView> VehicleAgent::commandView(Seconds now) const {
  if (!sent_) return std::nullopt;
  CommandView view = sent_->view;
  const bool drive = view.mode == wire::CommandMode::Drive;
  if (drive && now > sent_->effectiveAt + view.expiry) view.status = CommandStatus::Expired;
  if (!drive && view.status == CommandStatus::Acknowledged && last_ && last_->report.speed == 0)
    view.status = CommandStatus::Done;
  return view;
}

Sentence VehicleAgent::waitReason(Seconds now, const PortView& port) const {
  if (task_ == Task::Paused) return phrase("Core", "%1 waits: it was told to pause.").with(name_);
  if (task_ != Task::Running && task_ != Task::Jogging) return {};
  if (port.state != PortState::Open) {
    const bool lost = port.state == PortState::Lost;
    if (port.name.empty())
      return (lost ? phrase("Core", "%1 waits: the radio's port is lost.")
                   : phrase("Core", "%1 waits: the radio's port is not open."))
          .with(name_);
    return (lost ? phrase("Core", "%1 waits: the port %2 is lost.")
                 : phrase("Core", "%1 waits: the port %2 is not open."))
        .with(name_, port.name);
  }
  switch (contact_) {
    case Contact::Calling:
      return phrase("Core", "%1 waits: it has not answered our call yet.").with(name_);
    case Contact::Refused:
      return phrase("Core", "%1 waits: it cannot be talked to, see the events.").with(name_);
    case Contact::Silent:
      return phrase("Core", "%1 waits: it has not answered for %2 s.")
          .with(name_, decimal(last_ ? (now - last_->receivedAt).value() : 0.0, 0));
    case Contact::Connected:
      break;
  }
  if (!last_) return phrase("Core", "%1 waits: its first report has not come yet.").with(name_);
  const wire::Report& report = last_->report;
  switch (report.state) {
    case wire::VehicleState::Faulted:
      return phrase("Core", "%1 waits: a fault holds it until it is cleared.").with(name_);
    case wire::VehicleState::Calibrating:
      return phrase("Core", "%1 waits: it calibrates its compass.").with(name_);
    case wire::VehicleState::Obstacle:
      if ((report.faults & wire::kFaultRanger) != 0)
        return phrase("Core", "%1 waits: one of its rangers does not answer.").with(name_);
      if (report.range >= wire::kFarthestRange)
        return phrase("Core", "%1 waits: an obstacle stood before it.").with(name_);
      return phrase("Core", "%1 waits: an obstacle stands %2 cm before it.").with(name_, report.range);
    default:
      break;
  }
  if (task_ == Task::Jogging) return {};
  if (!estimate_.located)
    return phrase("Core", "%1 waits: its place is not known. Put it where it reads tags.").with(name_);
  if (decision_ && decision_->phase == drive::Phase::Lost)
    return phrase("Core", "%1 waits: %2").with(name_, drive::sentence(*decision_, follower_->route()));
  if (decision_ && decision_->phase == drive::Phase::Waiting) return zoneWait();
  if (report.state == wire::VehicleState::Expired)
    return phrase("Core", "%1 waits: its last command ran out.").with(name_);
  return {};
}

VehicleView VehicleAgent::view(Seconds now, const PortView& port, const link::LinkQuality& quality) const {
  VehicleView v;
  v.id = id();
  v.name = name_;
  v.contact = contact_;
  v.task = task_;
  v.firmware = firmware_;
  v.located = estimate_.located && last_.has_value();
  v.doubted = v.located && estimate_.doubted;
  const Expectation expected = last_ ? expectedAt(now) : Expectation{state()};
  const drive::VehicleState& rolled = expected.state;
  v.pose = rolled.pose;
  v.predicted = predicted_;
  Eigen::Matrix3d covariance = rolledOn(estimate_, rolled.pose.position - estimate_.pose.position);
  covariance.topLeftCorner<2, 2>() += expected.spread;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      v.covariance[static_cast<std::size_t>(3 * row + column)] = covariance(row, column);
  // When the report was made is not quite known either, and it has driven on meanwhile.
  if (last_) {
    const double late = (abs(estimate_.speed) * last_->sampledDoubt).value();
    const double x = late * std::cos(rolled.pose.heading.value());
    const double y = late * std::sin(rolled.pose.heading.value());
    v.covariance[0] += x * x;
    v.covariance[1] += x * y;
    v.covariance[3] += x * y;
    v.covariance[4] += y * y;
  }
  if (last_) {
    const wire::Report& report = last_->report;
    v.state = report.state;
    v.faults = report.faults;
    v.speed = MetresPerSecond{report.speed / 1000.0};
    v.heading = reportedHeading();
    v.headingBias = estimate_.headingBias;
    v.readersAnswering = report.readers;
    v.batteryVolts = report.battery / 10.0;
    if (report.range < wire::kFarthestRange) v.obstacle = Metres{report.range / 100.0};
  }
  v.link = {quality.lastHeard, quality.lastHeard ? now - *quality.lastHeard : now,
            quality.roundTrip, quality.loss,
            quality.reports,   quality.missed,
            quality.forged,    quality.replayed,
            quality.restarts,  quality.tagEventsLost};
  v.route = routeName_;
  if (follower_) v.length = follower_->route().length();
  if (decision_ && follower_) {
    v.progress = decision_->progress;
    v.crossTrack = decision_->crossTrack;
    v.doing = drive::sentence(*decision_, follower_->route());
  }
  if (task_ == Task::Jogging) v.doing = phrase("Core", "Driven by hand.");
  v.command = commandView(now);
  v.waits = waitReason(now, port);
  v.reads = reads_;
  v.recentReads = recentReads_;
  v.finished = task_ == Task::Finished;
  return v;
}

}  // namespace tessera::supervisor
