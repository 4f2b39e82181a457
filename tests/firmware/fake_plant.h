// A crude vehicle for closed loops: two wheels with first-order motors, friction, quantised encoders, a nose.
#pragma once

#include <array>
#include <cmath>

#include "tests/firmware/fake_board.h"

namespace tessera::firmware::test {

struct FakeWheel {
  double fullSpeed = 0.8;  ///< m/s at full duty
  double lag = 0.10;       ///< s
  double friction = 0.03;  ///< m/s
  double direction = 1.0;  ///< -1: encoder wired the wrong way round
  double tyre = 1.0;       ///< way over the floor for what the encoder tells; the loop's speed is the encoder's
  bool blocked = false;
  double speed = 0.0;  ///< m/s as the encoder tells it
  double way = 0.0;

  void step(double dt, int duty) {
    double target = fullSpeed * duty / 1000.0;
    target = std::fabs(target) <= friction ? 0.0 : target - std::copysign(friction, target);
    speed += (target - speed) * dt / lag;
    if (blocked) speed = 0.0;
    way += speed * dt;
  }
  double overFloor() const { return tyre * speed; }
  std::int32_t counts() const { return static_cast<std::int32_t>(std::floor(direction * way / (M_PI * 0.10 / 200.0))); }
};

struct FakePlant {
  std::array<FakeWheel, 2> wheels;
  double bearing = 0.0;  ///< clockwise from north, not wrapped
  double x = 0.0;        ///< eastwards
  double y = 0.0;        ///< northwards

  void step(FakeBoard& board, double dt) {
    for (std::size_t i = 0; i < 2; ++i) wheels[i].step(dt, board.duty[i]);
    bearing -= (wheels[1].overFloor() - wheels[0].overFloor()) / 0.30 * dt;
    x += speed() * std::sin(bearing) * dt;
    y += speed() * std::cos(bearing) * dt;
    for (std::size_t i = 0; i < 2; ++i) board.encoder[i] = wheels[i].counts();
    board.compass.field = {20.0 * std::cos(bearing), 20.0 * std::sin(bearing), 40.0};
  }
  double speed() const { return 0.5 * (wheels[0].overFloor() + wheels[1].overFloor()); }
  bool standing() const { return std::fabs(wheels[0].speed) < 0.005 && std::fabs(wheels[1].speed) < 0.005; }
};

}  // namespace tessera::firmware::test
