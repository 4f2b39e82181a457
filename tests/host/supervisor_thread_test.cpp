// The supervisor on its thread, over a real pty and QSerialPort.
#include "host/supervisor_thread.h"

#include <gtest/gtest.h>

#include <QCoreApplication>

#include "floor/site_json.h"
#include "host/pty_radio.h"

namespace tessera::host {
namespace {

using namespace std::chrono_literals;
using supervisor::EventKind;
using test::FakeVehicle;
using test::PtyRadio;

class SupervisorThreadTest : public ::testing::Test {
protected:
  SupervisorThreadTest()
      : map{floor::SiteMap::build(*floor::loadSite(std::string{TESSERA_SITES} + "/paper.tessera.json")).value()},
        vehicle{1, map->vehicle(VehicleId{1})->key},
        radio{{&vehicle}} {}

  void make() {
    thread = std::make_unique<SupervisorThread>(
        supervisor::Supervisor::create(map, {}).value(),
        PortChoice{PortChoice::Serial{QString::fromStdString(radio.name()), 115200}, {20ms, 100ms}});
    thread->start();
  }
  bool until(const std::function<bool()>& condition, double seconds = 10) {
    const Seconds end = steadyNow() + Seconds{seconds};
    while (!condition()) {
      if (steadyNow() > end) return false;
      radio.serve(2);
      QCoreApplication::processEvents();
      for (auto& e : thread->takeEvents()) events.push_back(std::move(e));
    }
    return true;
  }
  [[nodiscard]] int told(EventKind kind, bool over = false) const {
    return static_cast<int>(
        std::count_if(events.begin(), events.end(), [&](const auto& e) { return e.kind == kind && e.over == over; }));
  }
  [[nodiscard]] bool connected() const {
    const auto picture = thread->latest();
    return picture && picture->vehicles[0].contact == supervisor::Contact::Connected &&
           picture->vehicles[0].link.reports > 3;
  }
  // Serves the radio while close() waits on this thread.
  bool closeServed(std::chrono::milliseconds patience) {
    std::atomic<bool> done{false};
    std::thread server{[&] {
      while (!done) radio.serve(2);
    }};
    const bool stood = thread->close(patience);
    done = true;
    server.join();
    return stood;
  }

  std::shared_ptr<const floor::SiteMap> map;
  FakeVehicle vehicle;
  PtyRadio radio;
  std::unique_ptr<SupervisorThread> thread;
  std::vector<supervisor::Event> events;
};

TEST_F(SupervisorThreadTest, meetsAVehicleThroughThePort) {
  radio.put();
  make();
  EXPECT_TRUE(until([&] { return connected() && told(EventKind::Identified) == 1; }));
  EXPECT_EQ(told(EventKind::PortOpened), 1);
}

TEST_F(SupervisorThreadTest, announcesSnapshotsWithoutFloodingASlowReceiver) {
  int announced = 0;
  radio.put();
  make();
  QObject::connect(thread.get(), &SupervisorThread::snapshotChanged, [&] { ++announced; });
  const Seconds end = steadyNow() + Seconds{10};
  Seconds seen;
  for (int pictures = 0; pictures < 10 && steadyNow() < end; radio.serve(2)) {
    const auto latest = thread->latest();
    if (latest && latest->time > seen) ++pictures;
    if (latest) seen = latest->time;
  }
  QCoreApplication::processEvents();
  EXPECT_EQ(announced, 1) << "many snapshots, one word";
  EXPECT_TRUE(until([&] { return announced > 5; }));
}

TEST_F(SupervisorThreadTest, tellsAPulledPortOnceAndTakesItUpAgain) {
  radio.put();
  make();
  ASSERT_TRUE(until([&] { return connected(); }));
  radio.pull();
  ASSERT_TRUE(until([&] { return told(EventKind::PortLost) > 0; }));
  EXPECT_EQ(thread->latest()->port.state, supervisor::PortState::Lost);
  const auto reports = thread->latest()->vehicles[0].link.reports;
  until([] { return false; }, 0.5);
  EXPECT_EQ(told(EventKind::PortLost), 1) << "no storm";
  radio.put();
  ASSERT_TRUE(until([&] { return told(EventKind::PortLost, true) == 1; }));
  EXPECT_TRUE(until([&] { return thread->latest()->vehicles[0].link.reports > reports + 3; }));
}

TEST_F(SupervisorThreadTest, waitsForAPortThatIsNotThereYet) {
  make();
  ASSERT_TRUE(until([&] { return told(EventKind::PortLost) == 1; }));
  until([] { return false; }, 0.4);
  EXPECT_EQ(told(EventKind::PortLost), 1);
  EXPECT_NE(events[0].sentence.english().find("there is no such device"), std::string::npos)
      << events[0].sentence.english();
  radio.put();
  EXPECT_TRUE(until([&] { return connected(); }));
}

TEST_F(SupervisorThreadTest, stopsTheVehiclesBeforeItCloses) {
  radio.put();
  make();
  ASSERT_TRUE(until([&] { return connected(); }));
  EXPECT_TRUE(thread->post(supervisor::RunRoute{VehicleId{1}, "paper", MetresPerSecond{0.1}}));
  ASSERT_TRUE(
      until([&] { return !vehicle.commands.empty() && vehicle.commands.back().mode == wire::CommandMode::Drive; }));
  EXPECT_TRUE(closeServed(3000ms));
  EXPECT_EQ(vehicle.commands.back().mode, wire::CommandMode::Stop);
  EXPECT_FALSE(thread->post(supervisor::StopAll{})) << "closed";
}

TEST_F(SupervisorThreadTest, closesInTimeWhenTheVehicleIsDead) {
  radio.put();
  make();
  ASSERT_TRUE(until([&] { return connected(); }));
  vehicle.on = false;
  const Seconds begin = steadyNow();
  EXPECT_FALSE(closeServed(300ms));
  EXPECT_LT(steadyNow() - begin, Seconds{2.0});
}

TEST_F(SupervisorThreadTest, closesWithoutAPort) {
  make();
  const Seconds begin = steadyNow();
  thread->close(5000ms);
  EXPECT_LT(steadyNow() - begin, Seconds{2.0});
}

}  // namespace
}  // namespace tessera::host
