// One radio channel as every module on it meets it: half duplex, slow, and shared. Packets take the time that LoRa
// needs for them, two at once destroy each other, and some are lost for no visible reason.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/units.h"
#include "sim/channel_tap.h"
#include "sim/random_stream.h"

namespace tessera::sim {

inline constexpr int kAirRates = 6;
/// Nominal bit/s of the E32's air rate number 0 to 5; numbers beyond mean 5, as on the module.
[[nodiscard]] double bitRateOf(int airRate);
/// The number of a nominal bit rate (300, 1200, 2400, 4800, 9600, 19200); nullopt for any other.
[[nodiscard]] std::optional<int> airRateOf(double bitsPerSecond);
/// Time on air of `bytes` at an air rate by the LoRa formula (wire/airtime.h), before the factor seen in the field.
[[nodiscard]] Seconds timeOnAir(int airRate, std::size_t bytes);

struct AirSettings {
  double factor =
      1.8;  ///< time on air over the formula's; 1 to 3.2 were seen in the field, this is their geometric mean
  double loss = 0.02;  ///< probability that one receiver misses one packet
  Seconds delay{0.0};  ///< added to every packet after its end
};

/// What two modules must share to hear each other.
struct Tuning {
  int channel = 23;  ///< 410 + channel MHz
  int airRate = 5;
  bool operator==(const Tuning&) const = default;
};

struct Packet {
  std::vector<std::uint8_t> bytes;
  Tuning tuning;
  std::uint16_t address = 0;  ///< of the sender's group
  std::size_t sender = 0;
  Seconds start;
  Seconds end;
  bool destroyed = false;  ///< by a collision, by the tap, or because its sender lost power
};

struct AirCounters {
  std::uint64_t packets = 0;
  std::uint64_t collided = 0;   ///< of these, met another one
  std::uint64_t delivered = 0;  ///< counted per receiver
  std::uint64_t lost = 0;       ///< counted per receiver, by chance alone
};

/// Times never run backwards: a transmission starts after the instant of the last settle(). The same calls with the
/// same random stream give the same deliveries.
class Air {
public:
  Air(const AirSettings& settings, RandomStream random) : settings_{settings}, random_{random} {}

  /// A new module; it hears nothing until it is tuned.
  std::size_t join();
  /// Listens with this tuning from now on; nullopt: does not listen. A packet is heard only by who listens throughout.
  void tune(std::size_t module, std::optional<Tuning> tuning, Seconds now);
  /// Puts a packet on the air and returns when it ends. A module that sends hears nothing meanwhile, since its own
  /// packet destroys whatever else is on the channel.
  Seconds transmit(std::size_t module, const Tuning& tuning, std::uint16_t address, std::span<const std::uint8_t> bytes,
                   Seconds start);
  /// The module lost its power: what it has on the air breaks off.
  void breakOff(std::size_t module);
  /// A stranger's bytes, at most 58 a packet, each sent as soon as the channel is free.
  void inject(const Tuning& tuning, std::span<const std::uint8_t> bytes);

  struct Delivery {
    std::size_t module = 0;
    Packet packet;
    Seconds at;
  };
  /// Everything that reached a module by `now`, in order of time. Call after every module has run up to `now`.
  [[nodiscard]] std::vector<Delivery> settle(Seconds now);

  [[nodiscard]] ChannelTap& tap() { return tap_; }
  [[nodiscard]] const AirCounters& counters() const { return counters_; }
  /// Share of the time since the start that a module has spent sending (regulation asks for less than 0.1 at 433 MHz).
  [[nodiscard]] double dutyCycle(std::size_t module, Seconds now) const;
  [[nodiscard]] const AirSettings& settings() const { return settings_; }

private:
  struct Module {
    std::optional<Tuning> tuning;
    Seconds since;  ///< of this tuning
    Seconds sending;
  };
  struct Foreign {
    Tuning tuning;
    std::vector<std::uint8_t> bytes;
  };
  void deliver(const Packet& packet, std::vector<Delivery>& out);
  void sendForeign(Seconds now);
  [[nodiscard]] bool busy(int channel, Seconds now) const;

  AirSettings settings_;
  RandomStream random_;
  ChannelTap tap_;
  std::vector<Module> modules_;
  std::deque<Packet> under_;  ///< on the air, or over and not yet delivered
  std::deque<Foreign> foreign_;
  std::optional<std::size_t> stranger_;
  AirCounters counters_;
};

}  // namespace tessera::sim
