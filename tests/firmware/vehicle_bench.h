// A whole vehicle on a fake board with a fake plant, and a host that talks to it over ideal wires, in steps of 1 ms.
#pragma once

#include <functional>
#include <memory>

#include "firmware/vehicle/vehicle.h"
#include "tests/firmware/fake_plant.h"
#include "tests/firmware/fake_reader_bus.h"
#include "tests/firmware/test_host.h"

namespace tessera::firmware::test {

struct VehicleBench {
  static constexpr std::uint8_t kAddress = 5;
  static inline const wire::Key kKey{0xA0, 0xA1, 0xA2};

  FakeBoard board;
  FakePlant plant;
  FakeReaderBus bus;
  TestHost host{kAddress, kKey};
  std::unique_ptr<Vehicle> vehicle;
  std::function<void()> everyMs = [] {};

  explicit VehicleBench(const std::function<void(Settings&)>& change = [](Settings&) {}) {
    Settings s;
    s.set(wire::Parameter::Address, kAddress);
    s.key = kKey;
    change(s);
    board.memory.cells = makeEepromImage(s);
    board.e32.registers = radioRegisters(s);
    for (std::uint8_t i = 0; i < 3; ++i) bus.nodes[i] = {};
    bus.setMillivolts(12'000);
    switchOn();
  }
  void switchOn() { vehicle = std::make_unique<Vehicle>(board); }

  void run(int ms) {
    for (int i = 0; i < ms; ++i) {
      board.time += 1000;
      vehicle->poll();
      if (board.time % 10'000 == 0) vehicle->tick();
      plant.step(board, 0.001);
      bus.serve(board);
      host.take(board.takeOutgoing(Uart::Radio));
      everyMs();
    }
  }
  void send(const TestHost::Frame& frame) {
    board.incoming[0].insert(board.incoming[0].end(), frame.begin(), frame.end());
  }
  // Sends and runs until the answer has had time to come.
  void say(const TestHost::Frame& frame) {
    send(frame);
    run(5);
  }
  bool open(std::uint32_t nonce = 1) {
    run(200);
    say(host.hello(nonce));
    say(host.poll());
    return host.identity.has_value() && host.report.has_value();
  }
  // Commands every 100 ms with an expiry of half a second.
  void drive(std::int16_t mmPerSecond, double bearing, int ms) {
    const auto wire = static_cast<std::uint16_t>(std::lround(bearing / (2 * M_PI) * 65536.0));
    for (int i = 0; i < ms / 100; ++i) {
      send(host.drive(mmPerSecond, wire));
      run(100);
    }
  }
  wire::VehicleState state() {
    say(host.poll());
    return host.report->state;
  }
  wire::Value ask(wire::MessageType type, std::uint8_t parameter, std::int32_t value = 0) {
    host.value.reset();
    say(host.request(type, parameter, value));
    return host.value.value_or(wire::Value{0, 0, wire::Outcome::Failed, -1});
  }
};

}  // namespace tessera::firmware::test
