// The row of RFID readers across the vehicle's nose and the half-duplex bus on which the firmware asks them. Each
// reader tries to read on its own, by its own clock; the bus only tells the result of its last finished attempt.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <set>
#include <span>
#include <vector>

#include "base/pose.h"
#include "floor/site_map.h"
#include "floor/tag.h"
#include "sim/random_stream.h"

namespace tessera::sim {

struct ReaderParameters {
  Metres radius{0.06};        ///< of the disc in which a tag answers; half of the attempts at its very edge
  Metres edgeWidth{0.005};    ///< scale of the logistic edge
  double detection = 0.9;     ///< share of attempts well inside that succeed
  Seconds pollPeriod{0.1};    ///< from attempt to attempt
  double jitter = 0.05;       ///< of the period, uniform, either way
  Seconds readTime{0.02};     ///< from asking the floor to the result; a period shorter than this is prolonged
  double baud = 38400;        ///< of the bus
  Seconds turnRound{0.0005};  ///< from the end of a poll to the start of the answer
};

inline constexpr std::uint8_t kBatteryNode = 15;

class ReaderRow {
public:
  /// heads: in vehicle axes, in the order of reader numbers, at most 15.
  ReaderRow(const ReaderParameters& parameters, std::vector<Offset> heads, std::shared_ptr<const floor::SiteMap> map,
            std::uint64_t seed, std::uint64_t vehicle);

  /// Lets readers try, up to `now`. millivolts: what the battery gauge measures.
  void step(Seconds now, const Pose& vehicle, double volts);
  /// Bytes that the firmware has put on the bus. Those handed over in one go are taken to follow each other on the
  /// wire.
  void receive(std::span<const std::uint8_t> bytes, Seconds now);
  /// Bytes of answers whose last bit has passed by `now`.
  [[nodiscard]] std::vector<std::uint8_t> take(Seconds now);

  /// A dead reader answers nothing any more.
  void setDead(std::size_t reader, bool dead) { heads_.at(reader).dead = dead; }
  /// A dead tag answers no reader.
  void setDeadTag(const floor::TagUid& uid, bool dead);
  /// UID of the last finished attempt of a reader; empty when it found none.
  [[nodiscard]] const floor::TagUid& lastRead(std::size_t reader) const { return heads_.at(reader).result; }
  [[nodiscard]] std::uint64_t attempts(std::size_t reader) const { return heads_.at(reader).attempts; }

private:
  struct Head {
    Offset place;
    RandomStream random;
    Seconds next;    ///< start of the next attempt
    Seconds finish;  ///< end of the one under way
    bool trying = false;
    bool dead = false;
    floor::TagUid found;         ///< by the attempt under way
    floor::TagUid result;        ///< of the last finished one
    std::uint64_t attempts = 0;  ///< finished ones
  };
  struct TimedByte {
    Seconds end;
    std::uint8_t value;
  };
  void stepHead(Head& head, Seconds now, const Pose& vehicle);
  floor::TagUid attempt(Head& head, Point place) const;
  void poll(std::uint8_t node, Seconds at);
  void answer(std::uint8_t node, std::uint8_t counter, std::span<const std::uint8_t> data, Seconds at);

  ReaderParameters parameters_;
  std::vector<Head> heads_;
  std::shared_ptr<const floor::SiteMap> map_;
  std::set<floor::TagUid> deadTags_;
  std::uint16_t millivolts_ = 0;
  std::uint8_t gaugeCounter_ = 0;
  std::uint8_t address_ = 0;  ///< first byte of a poll, waiting for its complement; 0 none
  Seconds lineEnd_;           ///< when the last byte from the firmware has passed
  std::deque<TimedByte> answers_;
};

}  // namespace tessera::sim
