#include "supervisor/supervisor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "link/channel.h"
#include "supervisor/shared_magnetic_map.h"
#include "supervisor/site_change.h"
#include "supervisor/vehicle_agent.h"

namespace tessera::supervisor {

struct Supervisor::Impl {
  Impl(std::shared_ptr<const floor::SiteMap> map, const Config& c, const link::ChannelConfig& channelConfig)
      : site{std::move(map)}, config{c}, channel{channelConfig} {}

  std::shared_ptr<const floor::SiteMap> site;
  Config config;
  link::Channel channel;
  std::shared_ptr<traffic::Traffic> traffic;
  std::vector<VehicleAgent> agents;
  SharedMagneticMap magnetic;
  std::vector<Order> orders;
  EventLog log;
  PortView port;
  Episode portLost;
  Episode damaged{Seconds{5.0}};
  Episode strangers{Seconds{5.0}};
  std::uint32_t noiseSinceHeard = 0;
  std::uint32_t foreignSinceHeard = 0;
  Seconds nextSnapshot{-std::numeric_limits<double>::infinity()};

  VehicleAgent* agent(VehicleId id);
  void carryOut(const Order& order);
  void useSite(const UseSite& order);
  void hear(const link::LinkEvent& event, Seconds now);
  void hearNoise(const link::Noise& noise, Seconds now);
  void endEpisodes(Seconds now);
  [[nodiscard]] std::shared_ptr<const Snapshot> picture(Seconds now) const;
};

Supervisor::Supervisor(std::unique_ptr<Impl> impl) : impl_{std::move(impl)} {}
Supervisor::Supervisor(Supervisor&&) noexcept = default;
Supervisor& Supervisor::operator=(Supervisor&&) noexcept = default;
Supervisor::~Supervisor() = default;

Result<Supervisor> Supervisor::create(std::shared_ptr<const floor::SiteMap> map, Config config) {
  if (!map->contradictions().empty()) return failure(map->contradictions().front().sentence);
  const floor::Site& site = map->site();
  if (config.vehicles.empty())
    for (const floor::VehicleSetup& v : site.vehicles) config.vehicles.push_back(v.id);
  link::ChannelConfig channel;
  channel.airRate = site.radio.airRate;
  channel.baud = site.radio.baud;
  channel.nonceSeed = config.seed;
  const auto traffic = std::make_shared<traffic::Traffic>();
  traffic->zones = traffic::ZoneMap{site.zones};
  std::vector<VehicleAgent> agents;
  for (const VehicleId id : config.vehicles) {
    const floor::VehicleSetup* setup = map->vehicle(id);
    if (setup == nullptr)
      return failure("The site " + site.name + " has no vehicle with the address " + std::to_string(id.value) + ".");
    const auto offered = config.offeredKeys.find(id);
    channel.vehicles.push_back(
        {id, setup->key, offered == config.offeredKeys.end() ? std::nullopt : std::optional{offered->second}});
    auto agent = VehicleAgent::create(map, *setup, config.locator, config.controller, traffic);
    if (!agent) return tl::unexpected{agent.error()};
    agents.push_back(std::move(*agent));
  }
  auto impl = std::make_unique<Impl>(map, config, channel);
  impl->traffic = traffic;
  impl->agents = std::move(agents);
  impl->magnetic.use(impl->config.magnetic, impl->agents, impl->config.byMagneticMap);
  return Supervisor{std::move(impl)};
}

VehicleAgent* Supervisor::Impl::agent(VehicleId id) {
  const auto found = std::find_if(agents.begin(), agents.end(), [&](const VehicleAgent& a) { return a.id() == id; });
  return found == agents.end() ? nullptr : &*found;
}

void Supervisor::portOpened(std::string name, Seconds now) {
  Impl& s = *impl_;
  s.log.setTime(now);
  s.port = {PortState::Open, name, phrase("Core", "The port %1 is open.").with(name)};
  if (s.portLost.active()) {
    s.portLost.forget();
    s.log.tell(Severity::Info, EventKind::PortLost, std::nullopt, phrase("Core", "The port %1 is back.").with(name),
               true);
  } else {
    s.log.tell(Severity::Info, EventKind::PortOpened, std::nullopt, s.port.sentence);
  }
  s.channel.opened(now);
}

void Supervisor::portLost(const Sentence& why, Seconds now) {
  Impl& s = *impl_;
  // A text from the system may be a whole sentence.
  const bool whole = why.pattern() == nullptr && why.english().ends_with('.');
  const Sentence reason = whole ? Sentence{why.english().substr(0, why.english().size() - 1)} : why;
  s.log.setTime(now);
  s.channel.closed();
  s.port.state = PortState::Lost;
  s.port.sentence = s.port.name.empty() ? phrase("Core", "The radio's port is lost: %1.").with(reason)
                                        : phrase("Core", "The port %1 is lost: %2.").with(s.port.name, reason);
  if (s.portLost.seen(now) == Episode::Change::Begins)
    s.log.tell(Severity::Error, EventKind::PortLost, std::nullopt,
               phrase("Core", "%1 Vehicles stop by themselves; it is taken up again as soon as it is there.")
                   .with(s.port.sentence));
}

void Supervisor::ingest(std::span<const std::uint8_t> bytes, Seconds now) { impl_->channel.ingest(bytes, now); }

void Supervisor::post(Order order) { impl_->orders.push_back(std::move(order)); }

bool Supervisor::allStopped() const {
  return impl_->port.state != PortState::Open ||
         std::all_of(impl_->agents.begin(), impl_->agents.end(), [](const VehicleAgent& a) { return a.stopped(); });
}

TickOutput Supervisor::tick(Seconds now) {
  Impl& s = *impl_;
  TickOutput out;
  s.log.setTime(now);
  for (const Order& order : std::exchange(s.orders, {})) s.carryOut(order);
  // Twice: first what has been heard, so that commands are decided on the newest picture; then the air.
  for (const link::LinkEvent& e : s.channel.heard()) s.hear(e, now);
  const ChannelTiming timing{s.channel.effectiveAt(now), s.channel.cyclePeriod()};
  for (VehicleAgent& agent : s.agents) s.channel.wish(agent.id(), agent.decide(now, timing, s.log));
  link::Channel::Output air = s.channel.poll(now);
  for (const link::LinkEvent& e : air.events) s.hear(e, now);
  s.endEpisodes(now);
  s.magnetic.learn(s.agents, now);

  out.bytes = std::move(air.bytes);
  out.wake = std::min(air.wake, now + s.config.tick);
  if (now >= s.nextSnapshot || !s.log.empty()) {
    out.snapshot = s.picture(now);
    s.nextSnapshot = now + s.config.tick;
  }
  out.events = s.log.take();
  return out;
}

void Supervisor::Impl::carryOut(const Order& order) {
  if (std::holds_alternative<StopAll>(order)) {
    if (port.state == PortState::Open)
      log.tell(Severity::Info, EventKind::StoppedAll, std::nullopt, phrase("Core", "All vehicles were told to stop."));
    else
      log.tell(Severity::Warning, EventKind::StoppedAll, std::nullopt,
               phrase("Core",
                      "All vehicles shall stop. They cannot be told while the radio's port is not open: each stops by "
                      "itself when its command runs out."));
    for (VehicleAgent& a : agents) a.stop(log);
    return;
  }
  if (const auto* use = std::get_if<UseSite>(&order)) return useSite(*use);
  if (const auto* floor = std::get_if<UseMagneticMap>(&order))
    return magnetic.use(floor->map, agents, config.byMagneticMap);
  if (const auto* watch = std::get_if<Watch>(&order)) {
    for (VehicleAgent& a : agents) a.watch(a.id() == watch->who);
    return;
  }
  const VehicleId id = std::visit(
      [](const auto& o) {
        if constexpr (requires { o.vehicle; })
          return o.vehicle;
        else
          return VehicleId{};
      },
      order);
  VehicleAgent* a = agent(id);
  if (a == nullptr) {
    log.tell(Severity::Warning, EventKind::OrderRefused, std::nullopt,
             phrase("Core", "An order is for the vehicle %1, which is not looked after here.").with(id.value));
    return;
  }
  if (const auto* run = std::get_if<RunRoute>(&order)) a->run(*run, log);
  if (std::holds_alternative<Pause>(order)) a->pause(log);
  if (std::holds_alternative<Resume>(order)) a->resume(log);
  if (std::holds_alternative<Stop>(order)) a->stop(log);
  if (std::holds_alternative<Clear>(order)) a->clear();
  if (const auto* jog = std::get_if<Jog>(&order)) a->jog(*jog, log);
  if (const auto* pair = std::get_if<Pair>(&order); pair != nullptr && a->mayBePaired(log))
    if (!channel.pair(id, pair->newKey))
      log.tell(
          Severity::Warning, EventKind::OrderRefused, id,
          phrase("Core", "%1: it is being given a key already, or too many requests are waiting.").with(a->name()));
  if (const auto* ask = std::get_if<Ask>(&order)) {
    if (ask->request.type != wire::MessageType::Get) a->forgetCompass();
    // A Stop is repeated for as long as it holds, and would end the turn at once.
    const auto action = static_cast<wire::Action>(ask->request.parameter);
    const bool moves = ask->request.type == wire::MessageType::Do &&
                       (action == wire::Action::CalibrateCompass || action == wire::Action::SurveyCompass);
    if (moves && !a->letGo(log)) return;
    if (!channel.request(id, ask->request))
      log.tell(Severity::Warning, EventKind::OrderRefused, id,
               phrase("Core", "%1: too many requests are waiting already.").with(a->name()));
  }
}

void Supervisor::Impl::useSite(const UseSite& order) {
  if (order.map && !order.map->contradictions().empty()) {
    log.tell(Severity::Warning, EventKind::OrderRefused, std::nullopt, order.map->contradictions().front().sentence);
    return;
  }
  // A vehicle that was paired meanwhile may stand in the site with its new key.
  std::vector<floor::VehicleSetup> before = site->site().vehicles;
  for (floor::VehicleSetup& was : before) {
    const auto* now = order.map ? order.map->vehicle(was.id) : nullptr;
    const auto* peer = channel.peer(was.id);
    if (now != nullptr && peer != nullptr && now->key == peer->session.longTermKey()) was.key = now->key;
  }
  if (!order.map || !sameFleet(site->site().radio, before, order.map->site())) {
    log.tell(Severity::Warning, EventKind::OrderRefused, std::nullopt,
             phrase("Core",
                    "The site's vehicles or its radio have changed: supervision must be restarted to take them over."));
    return;
  }
  const bool otherZones = site->site().zones != order.map->site().zones;
  site = order.map;
  for (VehicleAgent& a : agents) a.use(site);
  if (!otherZones) return;
  *traffic = {traffic::ZoneMap{site->site().zones}, {}};
  for (VehicleAgent& a : agents) a.useTraffic();
}

void Supervisor::Impl::hear(const link::LinkEvent& event, Seconds now) {
  std::visit(
      [&](const auto& e) {
        using E = std::decay_t<decltype(e)>;
        if constexpr (std::is_same_v<E, link::Noise>) {
          hearNoise(e, now);
        } else {
          VehicleAgent* a = agent(e.vehicle);
          if (a == nullptr) return;
          if constexpr (std::is_same_v<E, link::Reported>) noiseSinceHeard = foreignSinceHeard = 0;
          if constexpr (std::is_same_v<E, link::Answered>)
            log.tellAnswer(e.value ? Severity::Info : Severity::Warning, e.vehicle, answerSentence(a->name(), e),
                           {e.request, e.value});
          else if constexpr (std::is_same_v<E, link::CommandSent> || std::is_same_v<E, link::CommandAcknowledged> ||
                             std::is_same_v<E, link::CommandUnanswered>)
            a->take(e);
          else if constexpr (std::is_same_v<E, link::PairingEnded>)
            a->take(e, channel.peer(e.vehicle)->session.open(), log);
          else if constexpr (std::is_same_v<E, link::Silent> || std::is_same_v<E, link::Disbelieved>)
            a->take(e, now, log);
          else
            a->take(e, log);
        }
      },
      event);
}

void Supervisor::Impl::hearNoise(const link::Noise& noise, Seconds now) {
  noiseSinceHeard += noise.damaged + noise.skipped;
  foreignSinceHeard += noise.foreign;
  const bool bad = noise.damaged > 0 || noise.skipped > 0;
  if (bad && damaged.seen(now, std::max(noise.damaged, 1U)) == Episode::Change::Begins)
    log.tell(
        Severity::Warning, EventKind::DamagedFrames, std::nullopt,
        phrase("Core",
               "Damaged bytes come from the radio and are dropped: noise, two senders at once, or a changed byte."));
  if (noise.foreign > 0 && strangers.seen(now, noise.foreign) == Episode::Change::Begins)
    log.tell(Severity::Warning, EventKind::StrangeFrames, std::nullopt,
             phrase("Core",
                    "Somebody who does not belong to this site sends on the radio channel; the frames are dropped."));
}

void Supervisor::Impl::endEpisodes(Seconds now) {
  if (damaged.notSeen(now) == Episode::Change::Ends)
    log.tell(Severity::Info, EventKind::DamagedFrames, std::nullopt,
             phrase("Core", "No more damaged bytes from the radio; %1 stretches were dropped.").with(damaged.count()),
             true);
  if (strangers.notSeen(now) == Episode::Change::Ends)
    log.tell(Severity::Info, EventKind::StrangeFrames, std::nullopt,
             phrase("Core", "No more strangers on the radio channel; %1 frames were dropped.").with(strangers.count()),
             true);
}

std::shared_ptr<const Snapshot> Supervisor::Impl::picture(Seconds now) const {
  auto snapshot = std::make_shared<Snapshot>();
  snapshot->time = now;
  snapshot->port = port;
  const link::AirTiming& timing = channel.timing();
  const auto& heard = channel.counters();
  const Seconds slot{timing.slotUnits() * wire::kSlotUnitMs / 1000.0};
  snapshot->channel = {channel.cyclePeriod(), slot,          timing.factor(), timing.delay(),   heard.frames,
                       heard.badCrc,          heard.skipped, noiseSinceHeard, foreignSinceHeard};
  for (const VehicleAgent& agent : agents)
    snapshot->vehicles.push_back(agent.view(now, port, channel.peer(agent.id())->quality));
  for (const VehicleAgent& agent : agents)
    if (auto watched = agent.locatingView()) snapshot->watched = std::move(watched);
  snapshot->magnetic = magnetic.picture();
  return snapshot;
}

}  // namespace tessera::supervisor
