// Reads what the emulator logs: writes to the PWM block, which it does not emulate, and levels of output pins. The
// wording is QEMU's own and no promise of its makers; tests/sim_qemu notices when it changes.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <variant>

namespace tessera::sim {

struct PwmWrite {
  std::uint32_t offset = 0;  ///< from the block's start
  std::uint32_t value = 0;
  bool operator==(const PwmWrite&) const = default;
};
struct PinLevel {
  std::string port;  ///< QOM path of the port
  unsigned pin = 0;
  bool high = false;
  bool operator==(const PinLevel&) const = default;
};
/// The port's registers went back to their start values, as at every reset of the processor.
struct PortReset {
  std::string port;
  bool operator==(const PortReset&) const = default;
};
/// A line that none of the above fits: a message of the emulator.
struct Remark {
  std::string text;
  bool operator==(const Remark&) const = default;
};
using TraceEvent = std::variant<PwmWrite, PinLevel, PortReset, Remark>;

[[nodiscard]] TraceEvent parseTraceLine(std::string_view line);

/// Cuts a stream of bytes into lines.
class LineCutter {
public:
  /// Calls sink(std::string_view) for each line that is complete now, without its end.
  void feed(std::string_view bytes, const std::function<void(std::string_view)>& sink);
  [[nodiscard]] const std::string& pending() const { return rest_; }

private:
  std::string rest_;
};

}  // namespace tessera::sim
