// The ultrasonic rangers HC-SR04: asked in turn, cleaned of outliers, and the question whether something stands in the
// way. Each is pinged every 80 ms, half of that apart from the other one, so that no echo is taken for another's. A
// ranger with nothing in its reach ends its pulse by itself after 38 ms; one that gives no pulse does not answer.
#pragma once

#include <array>
#include <cstdint>

#include "firmware/vehicle/board.h"
#include "firmware/vehicle/time.h"

namespace tessera::firmware {

class Rangers {
public:
  explicit Rangers(Board& board) : board_{board} {}

  /// stopDistance in m; 0 never sees an obstacle.
  void configure(float stopDistance) { stopDistance_ = stopDistance; }
  /// To be called every tick.
  void tick(Micros now);

  /// Something is nearer than the stop distance, or was within the last second. It counts as gone when it is 5 cm
  /// further away than that, for a second without a break. A faulty ranger counts as an obstacle: nobody looks there.
  [[nodiscard]] bool obstacle() const { return obstacle_ || (stopDistance_ > 0.0F && faulty()); }
  /// Distance to the nearest obstacle for Report::range: cm, at most 254, 255 = none seen. Of faulty rangers none.
  [[nodiscard]] std::uint8_t nearestCm() const;
  /// A ranger does not answer: five pings running without a pulse, or ten with pulses shorter than 2 cm, as a bad line
  /// makes them. Over when it has answered each ping for a second.
  [[nodiscard]] bool faulty() const;

private:
  static constexpr std::size_t kWindow = 5;
  static constexpr float kFree = 1e3F;
  struct Ranger {
    std::array<float, kWindow> last{kFree, kFree, kFree, kFree, kFree};  ///< m
    std::size_t next = 0;
    bool pinged = false;
    int silent = 0;        ///< pings without a pulse, running
    int tooShort = 0;      ///< pulses too short for any distance, running
    Micros unanswered{0};  ///< when one of both was last found
    bool faulty = false;
    float distance = kFree;  ///< m, median of the last five
  };
  static void collect(Ranger& ranger, std::uint32_t echo, Micros now);
  static void take(Ranger& ranger, float distance);
  [[nodiscard]] float nearest() const;
  void judge(Micros now);

  Board& board_;
  std::array<Ranger, kRangers> rangers_{};
  float stopDistance_ = 0.0F;
  std::size_t turn_ = 0;
  Micros next_{0};
  bool obstacle_ = false;
  Micros seen_{0};  ///< when the way was last not clear
};

}  // namespace tessera::firmware
