// The supervisor on a thread of its own at the pace of the clock, before a simulated world in memory, and a window's
// threads that watch and order: the hand-over of core/host without Qt, so that ThreadSanitizer sees all of it.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <random>
#include <thread>

#include "app/world/make_world.h"
#include "floor/site_json.h"
#include "supervisor/pump.h"

namespace tessera::supervisor {
namespace {

using namespace std::chrono_literals;

Seconds steadyNow() {
  return Seconds{std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count()};
}

// As host::SupervisorWorker and host::SupervisorThread: one thread owns the port and the pump, turns when bytes came,
// an order was posted or the instant has come that the last turn named, and leaves by itself once closed.
class Worker {
public:
  explicit Worker(const floor::Site& site) : map{floor::SiteMap::build(site).value()} {
    world::WorldOptions options;
    auto made = world::makeWorld(options, site, steadyNow());
    if (!made) throw std::runtime_error{made.error().sentence};
    made_ = std::make_unique<world::MadeWorld>(std::move(*made));
    if (auto started = made_->world->startAll(); !started) throw std::runtime_error{started.error().sentence};
    thread_ = std::thread{[this] { run(); }};
  }
  ~Worker() { close(2s); }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  // From any thread.
  bool post(Order order) {
    if (closing_ || !mailbox->post(std::move(order))) return false;
    orderTold_ = true;
    return true;
  }
  /// True: all vehicles stood before the port was closed.
  bool close(std::chrono::milliseconds patience) {
    patience_ = patience.count();
    closing_ = true;
    if (thread_.joinable()) thread_.join();
    return allStood_;
  }
  /// Only after close(): until then the world is the worker's.
  [[nodiscard]] sim::World& world() { return *made_->world; }

  const std::shared_ptr<const floor::SiteMap> map;
  const std::shared_ptr<Mailbox> mailbox = std::make_shared<Mailbox>();
  std::atomic<bool> newSnapshot{false};
  std::atomic<bool> newEvents{false};
  std::atomic<std::uint64_t> turns{0};

private:
  void run() {
    Pump pump{Supervisor::create(map, {}).value(), mailbox};
    pump.supervisor().portOpened("memory", steadyNow());
    Seconds wake;
    for (bool closed = false; !closed; std::this_thread::sleep_for(500us)) {
      if (closing_) pump.close(closeBy());
      const Seconds now = steadyNow();
      made_->world->advance(now);
      const auto bytes = made_->world->takeHostBytes();
      if (!bytes.empty()) pump.supervisor().ingest(bytes, now);
      if (bytes.empty() && now < wake && !orderTold_.exchange(false) && !closing_) continue;
      const Pump::Turn turn = pump.turn(now);
      wake = turn.wake;
      ++turns;
      if (!turn.bytes.empty()) made_->world->hostBytes(turn.bytes);
      if (turn.newSnapshot) newSnapshot = true;
      if (turn.newEvents) newEvents = true;
      closed = turn.closed;
    }
    allStood_ = pump.supervisor().allStopped();
  }
  Seconds closeBy() {
    if (!deadline_) deadline_ = steadyNow() + Seconds{static_cast<double>(patience_.load()) / 1000.0};
    return *deadline_;
  }

  std::unique_ptr<world::MadeWorld> made_;
  std::optional<Seconds> deadline_;
  std::atomic<bool> orderTold_{false};
  std::atomic<bool> closing_{false};
  std::atomic<bool> allStood_{false};
  std::atomic<long> patience_{0};
  std::thread thread_;
};

// What a window's thread does: looks when it is told, reads whatever a view would show, keeps old pictures for a while.
class Window {
public:
  explicit Window(Worker& worker) : worker_{worker} {}
  void look() {
    if (worker_.newSnapshot.exchange(false)) {
      if (auto picture = worker_.mailbox->latest()) {
        EXPECT_GE(picture->time, seen_) << "time runs on";
        seen_ = picture->time;
        for (const VehicleView& v : picture->vehicles)
          letters_ += v.doing.english().size() + v.waits.arguments().size();
        if (kept_.size() == 50) kept_.clear();
        kept_.push_back(std::move(picture));
        ++pictures;
      }
    }
    if (worker_.newEvents.exchange(false))
      for (Event& event : worker_.mailbox->takeEvents()) events.push_back(std::move(event));
  }
  bool until(const std::function<bool()>& condition, const char* what, double seconds = 60) {
    const Seconds end = steadyNow() + Seconds{seconds};
    while (!condition()) {
      look();
      if (steadyNow() > end) {
        ADD_FAILURE() << "not within " << seconds << " s: " << what << told();
        return false;
      }
      std::this_thread::sleep_for(2ms);
    }
    return true;
  }
  [[nodiscard]] const VehicleView* view() const { return kept_.empty() ? nullptr : kept_.back()->find(VehicleId{1}); }
  [[nodiscard]] bool shows(Task task) const { return view() != nullptr && view()->task == task; }
  [[nodiscard]] double speed() const { return view() == nullptr ? 0.0 : view()->speed.value(); }
  [[nodiscard]] bool told(EventKind kind) const {
    return std::any_of(events.begin(), events.end(), [&](const Event& e) { return e.kind == kind; });
  }
  /// What a window would show of it.
  [[nodiscard]] std::string told() const {
    std::string all;
    if (view() != nullptr) all += "\n" + view()->doing.english() + " " + view()->waits.english();
    for (const Event& event : events) all += "\n" + event.sentence.english();
    return all;
  }

  std::vector<Event> events;
  int pictures = 0;

private:
  Worker& worker_;
  std::vector<std::shared_ptr<const Snapshot>> kept_;
  Seconds seen_;
  std::size_t letters_ = 0;
};

TEST(SupervisorThreads, aWindowWatchesAndOrdersWhileOthersEditTheSiteAndReadAlong) {
  const floor::Site site = floor::loadSite(std::string{TESSERA_SITES} + "/paper.tessera.json").value();
  Worker worker{site};
  Window window{worker};
  const VehicleId one{1};
  const auto run = [&](const char* route) { return worker.post(RunRoute{one, route, MetresPerSecond{0.3}}); };

  // Somebody drags a vertex and what stands is handed over again and again; a journal or another view reads along.
  std::atomic<bool> over{false};
  std::thread editor{[&] {
    for (int i = 0; !over; ++i) {
      floor::Site edited = site;
      edited.routes.push_back(edited.routes[0]);
      edited.routes.back().name = "edited";
      edited.routes.back().vertices.back().x += Metres{0.001 * (i % 100)};
      if (i % 10 == 0) edited.looseTags.push_back({floor::TagUid::parse("04A1B2C3D4E5F6").value(), {}});
      worker.post(UseSite{floor::SiteMap::build(std::move(edited)).value()});
      std::this_thread::sleep_for(15ms);
    }
  }};
  std::thread reader{[&] {
    std::size_t letters = 0;
    while (!over) {
      const auto picture = worker.mailbox->latest();
      if (picture)
        letters += Sentence{picture->port.sentence}.english().size() + picture->vehicles[0].recentReads.size();
      std::this_thread::sleep_for(200us);
    }
    EXPECT_GT(letters, 0U);
  }};

  window.until([&] { return window.view() && window.view()->contact == Contact::Connected; }, "contact");
  EXPECT_TRUE(run("paper"));
  window.until([&] { return window.speed() > 0.1; }, "the vehicle drives");
  worker.post(Pause{one});
  window.until([&] { return window.shows(Task::Paused) && window.speed() == 0.0; }, "it pauses");
  worker.post(Resume{one});
  window.until([&] { return window.speed() > 0.1; }, "it goes on");
  worker.post(Ask{one, {wire::MessageType::Get, static_cast<std::uint8_t>(wire::Parameter::MaxSpeed), 0}});
  window.until([&] { return window.told(EventKind::Answer); }, "an answer");
  worker.post(StopAll{});
  window.until([&] { return window.shows(Task::Stopped) && window.speed() == 0.0; }, "it stops");
  for (int i = 0; i < 15; ++i) {
    worker.post(Jog{one, MetresPerSecond{-0.1}, RadiansPerSecond{}});
    window.look();
    std::this_thread::sleep_for(50ms);
  }
  window.until([&] { return window.told(EventKind::DrivenByHand); }, "driven by hand");
  window.until([&] { return window.shows(Task::Stopped) && window.speed() == 0.0; }, "the dead-man's stop");
  run("edited");
  window.until([&] { return window.speed() > 0.1 && window.view()->route == "edited"; }, "the edited route");
  run("moon");
  window.until([&] { return window.told(EventKind::OrderRefused); }, "a refusal");

  EXPECT_TRUE(worker.close(20s)) << "the vehicle stands before the port is closed";
  over = true;
  editor.join();
  reader.join();
  EXPECT_FALSE(worker.post(StopAll{})) << "closed";
  EXPECT_EQ(worker.world().truth(one)->speed.value(), 0.0);
  EXPECT_GT(window.pictures, 20);
  EXPECT_EQ(worker.mailbox->eventsDropped(), 0U);
}

TEST(SupervisorThreads, closingInTheMiddleOfEverythingEndsInTime) {
  const floor::Site site = floor::loadSite(std::string{TESSERA_SITES} + "/three.tessera.json").value();
  Worker worker{site};
  const Seconds end = steadyNow() + Seconds{60};
  const auto connected = [&] {
    const auto picture = worker.mailbox->latest();
    return picture && std::all_of(picture->vehicles.begin(), picture->vehicles.end(),
                                  [](const VehicleView& v) { return v.contact == Contact::Connected; });
  };
  while (!connected() && steadyNow() < end) std::this_thread::sleep_for(5ms);
  EXPECT_TRUE(connected());
  std::atomic<bool> over{false};
  std::vector<std::thread> operators;
  for (unsigned seed = 1; seed <= 3; ++seed)
    operators.emplace_back([&, seed] {
      std::mt19937 random{seed};
      while (!over) {
        const VehicleId id{static_cast<std::uint8_t>(1 + random() % 3)};
        const Order orders[] = {RunRoute{id, "one", MetresPerSecond{0.2}},
                                Pause{id},
                                Resume{id},
                                Jog{id, MetresPerSecond{0.1}, RadiansPerSecond{0.3}},
                                Clear{id},
                                Stop{id},
                                StopAll{},
                                UseSite{worker.map}};
        worker.post(orders[random() % std::size(orders)]);
        (void)worker.mailbox->takeEvents();
        (void)worker.mailbox->latest();
        std::this_thread::sleep_for(1ms);
      }
    });
  std::this_thread::sleep_for(1s);
  const Seconds begin = steadyNow();
  worker.close(2s);
  EXPECT_LT((steadyNow() - begin).value(), 10.0);
  over = true;
  for (std::thread& t : operators) t.join();
}

}  // namespace
}  // namespace tessera::supervisor
