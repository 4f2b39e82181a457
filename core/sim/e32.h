// The E32-TTL-100 radio module (SX1278, data sheet v1.2) as seen from its pins: UART, M0/M1, AUX. Sans IO; instants are
// exact whatever the steps in which it is advanced. Not modelled: fixed transmission (the bit reads back 0), wake-up
// and power-saving modes (deaf and mute), parity (always 8N1), a UART at another rate than the module's.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "firmware/vehicle/board.h"
#include "sim/air.h"

namespace tessera::sim {

/// ADDH ADDL SPED CHAN OPTION, as read and written over the UART; all that a module keeps without power.
struct E32Registers {
  std::array<std::uint8_t, 5> bytes{0x00, 0x00, 0x1A, 0x17, 0x44};  ///< from the factory: 9600 8N1, 2.4k, channel 23

  /// airRate 0 to 5, channel 0 to 31, baud one of 1200 to 115200 (others count as 9600).
  [[nodiscard]] static E32Registers of(int channel, int airRate, int baud);
  [[nodiscard]] std::uint16_t address() const;
  [[nodiscard]] int baud() const;
  [[nodiscard]] Tuning tuning() const;
  bool operator==(const E32Registers&) const = default;
};

struct E32Counters {
  std::uint64_t overflow = 0;  ///< bytes dropped because a buffer was full
  std::uint64_t deaf = 0;      ///< UART bytes dropped during a change of mode, or in a mode that takes none
  std::uint64_t sent = 0;      ///< packets
  std::uint64_t received = 0;  ///< packets
};

class E32 {
public:
  static constexpr std::size_t kPacket = 58;
  static constexpr std::size_t kBuffer = 512;

  /// Joins the air, powered, in normal mode. The air must outlive the module. handover: the neighbour's bytes are
  /// handed over in steps of this length, so that a shorter pause in them says nothing; a short packet leaves that much
  /// later.
  E32(Air& air, const E32Registers& stored, Seconds handover = {});

  /// Bytes that the neighbour hands to its UART now; they arrive one byte time after another.
  void fromUart(std::span<const std::uint8_t> bytes, Seconds now);
  /// Bytes handed over that are still on the way to the module: a polite neighbour waits while there are many.
  [[nodiscard]] std::size_t onWire() const { return wire_.size(); }
  void setMode(firmware::RadioMode mode, Seconds now);
  /// Does everything due by `now`. Call with growing instants, before ready() and takeUart().
  void advance(Seconds now);
  /// Bytes whose last bit has left the module's UART by `now`.
  [[nodiscard]] std::vector<std::uint8_t> takeUart(Seconds now);
  /// AUX at the instant of the last advance(): true = high = idle.
  [[nodiscard]] bool ready() const;
  /// A packet that ended at `at`, from the air.
  void receive(const Packet& packet, Seconds at);
  /// Without power it forgets everything but its saved registers.
  void setPowered(bool powered, Seconds now);

  [[nodiscard]] std::size_t module() const { return module_; }
  [[nodiscard]] const E32Registers& registers() const { return working_; }
  [[nodiscard]] const E32Registers& saved() const { return saved_; }
  [[nodiscard]] firmware::RadioMode mode() const { return mode_; }
  [[nodiscard]] const E32Counters& counters() const { return counters_; }

private:
  struct Timed {
    std::uint8_t byte = 0;
    Seconds at;
  };
  [[nodiscard]] Seconds byteTime() const;
  [[nodiscard]] std::optional<Seconds> packetDue() const;
  bool runOne(Seconds now);
  void arrive(const Timed& byte);
  void startPacket(Seconds at);
  void command(const Timed& byte);
  void answer(std::span<const std::uint8_t> bytes, Seconds from);
  bool changeMode(Seconds now);
  void listen(Seconds now);

  Air& air_;
  std::size_t module_;
  Seconds handover_;
  E32Registers saved_;
  E32Registers working_;
  E32Counters counters_;
  bool powered_ = true;
  firmware::RadioMode mode_ = firmware::RadioMode::Normal;
  std::optional<firmware::RadioMode> wanted_;
  Seconds wantedSince_;
  Seconds now_;
  std::deque<Timed> wire_;    ///< handed over by the neighbour, not yet arrived
  std::deque<Timed> buffer_;  ///< arrived, waiting for the air
  std::deque<Timed> output_;  ///< towards the neighbour; `at` is the end of its last bit
  Seconds wireFree_;
  Seconds airFree_;
  Seconds outputFree_;
  std::vector<std::uint8_t> command_;
};

}  // namespace tessera::sim
