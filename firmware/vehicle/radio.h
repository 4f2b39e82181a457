// The E32-TTL-100 radio module: sets its registers at the start, then carries whole frames in transparent mode.
#pragma once

#include <array>
#include <cstdint>

#include "firmware/vehicle/board.h"
#include "firmware/vehicle/settings.h"
#include "firmware/vehicle/time.h"
#include "wire/frame.h"

namespace tessera::firmware {

/// The module's registers that the settings ask for: C0 ADDH ADDL SPED CHAN OPTION. Address 0 for all on a channel,
/// 8N1, transparent, push-pull, forward error correction, full power; C0 keeps them over a power cut.
[[nodiscard]] std::array<std::uint8_t, 6> radioRegisters(const Settings& settings);

class Radio {
public:
  explicit Radio(Board& board) : board_{board} {}

  /// Begins to configure the module: mode 3, 9600 baud, read, compare, write where different, read again. When it
  /// does not take its parameters three times over, faulty() stays true and the radio is used all the same; while no
  /// frame is heard, as it may be tuned elsewhere, all this is tried again each five seconds.
  void start(const Settings& settings, Micros now);

  /// Calls sink(const wire::Frame&) for each whole frame that has come in. 20 ms of silence (or five byte times, if
  /// that is longer) end a half frame.
  template <class Sink>
  void poll(Micros now, Sink&& sink) {
    if (state_ != State::Talking) {
      configure(now);
      return;
    }
    std::array<std::uint8_t, 64> buffer{};
    const auto hear = [&](const wire::Frame& frame) {
      lastFrame_ = now;
      sink(frame);
    };
    if (const std::size_t n = board_.read(Uart::Radio, buffer); n > 0) {
      lastByte_ = now;
      decoder_.feed(wire::Bytes{buffer}.first(n), hear);
    } else if (decoder_.pending() && now - lastByte_ > silence_) {
      decoder_.flush(hear);
    }
    pushOut();
    if (faulty_ && now - lastFrame_ > kDeafFor) begin(now);
  }

  /// True when a frame may be handed over now: configured, the module idle, nothing under way.
  [[nodiscard]] bool canSend();
  /// Sends one whole frame (at most wire::kMaxFrame bytes). False, and nothing is sent, unless canSend().
  bool send(wire::Bytes frame);
  /// Every byte handed over has reached the module.
  [[nodiscard]] bool sent();

  [[nodiscard]] bool faulty() const { return faulty_; }
  [[nodiscard]] bool talking() const { return state_ == State::Talking; }
  [[nodiscard]] std::uint32_t damagedFrames() const { return decoder_.counters().badCrc; }

private:
  enum class State : std::uint8_t { Off, Enter, Answer, Write, Leave, Settle, Talking };
  static constexpr Micros kDeafFor = 5s;
  void begin(Micros now);
  void configure(Micros now);
  void go(State next, Micros now);
  void ask(Micros now);
  void takeAnswer(Micros now);
  void pushOut();
  [[nodiscard]] bool idleFor(Micros quiet, Micros now);

  Board& board_;
  wire::FrameDecoder decoder_;
  std::array<std::uint8_t, 6> wanted_{};
  std::array<std::uint8_t, 6> answer_{};
  std::size_t answered_ = 0;
  std::array<std::uint8_t, wire::kMaxFrame> out_{};
  std::size_t outSize_ = 0;
  std::size_t outDone_ = 0;
  State state_ = State::Off;
  Micros entered_{0};
  Micros busyUntil_{0};
  Micros lastByte_{0};
  Micros lastFrame_{0};  ///< or when it began to listen
  Micros silence_{20ms};
  std::uint32_t baud_ = 9600;
  int tries_ = 0;
  bool faulty_ = false;
};

}  // namespace tessera::firmware
