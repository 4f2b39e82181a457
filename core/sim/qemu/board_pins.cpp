#include "sim/qemu/board_pins.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "sim/qemu/monotonic.h"

namespace tessera::sim {
namespace {

constexpr std::array<std::uint64_t, 4> kPortAddresses = {0x40004000, 0x40006000, 0x40007000, 0x40024000};
constexpr const char* kInterruptMask = "0x40004410";                      // port A
constexpr const char* kRawInterruptStatus = "0x40004414";                 // port A
constexpr unsigned kEncoderMask = 0x3C;                                   // port A
constexpr std::array<unsigned, 2> kEncoderPin = {2, 4};                   // port A: channel A; B is the next one
constexpr std::array<unsigned, 2> kDirectionPin = {4, 5};                 // port C
constexpr std::array<unsigned, firmware::kRangers> kTriggerPin = {4, 6};  // port D
constexpr std::array<unsigned, firmware::kRangers> kEchoPin = {5, 7};     // port D
constexpr unsigned kAuxPin = 2;                                           // port E

// Each value set costs the emulator some 50 µs. The field is looked at as often as the compass measures at most; a
// change that a turn of two degrees makes is shown at once, noise at every third look.
constexpr Seconds kFieldPeriod{1.0 / 75.0};
constexpr int kNoiseEvery = 3;
constexpr double kFieldTurn = 0.75;   // µT
constexpr double kFieldStep = 0.05;   // µT: half of the compass' resolution
constexpr double kFieldMost = 186.0;  // µT: beyond, and below 0, the emulated compass takes no values

/// The word at an address of the emulated memory.
Result<std::uint64_t> readWord(QemuLink& link, const char* address) {
  const auto answers = link.pins({std::string{"readl "} + address});
  if (!answers) return passOn(answers);
  constexpr std::string_view kBefore = "OK 0x";
  std::string_view answer = answers->front();
  if (answer.starts_with(kBefore)) answer.remove_prefix(kBefore.size());
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(answer.data(), answer.data() + answer.size(), value, 16);
  if (error != std::errc{} || end != answer.data() + answer.size())
    return failure("The emulator does not tell registers as expected: '" + answers->front() + "'.");
  return value;
}

/// What the emulator of this board always says; it explains nothing.
bool isHabitual(std::string_view remark) {
  return remark.empty() || remark.starts_with("Timer with period zero") ||
         remark.find("warning:") != std::string_view::npos;
}

}  // namespace

Result<void> BoardPins::find(QemuLink& link) {
  const auto children = link.control("qom-list", {{"path", "/machine/unattached"}});
  if (!children) return passOn(children);
  for (const auto& child : *children) {
    if (child.value("type", "").find("pl061") == std::string::npos) continue;
    const std::string path = "/machine/unattached/" + child.value("name", "");
    const auto address = link.control("qom-get", {{"path", path + "/pl061[0]"}, {"property", "addr"}});
    if (!address) return passOn(address);
    for (std::size_t i = 0; i < kPorts; ++i) {
      if (address->is_number_unsigned() && address->get<std::uint64_t>() == kPortAddresses[i]) portPaths_[i] = path;
    }
  }
  if (std::ranges::any_of(portPaths_, &std::string::empty))
    return failure("This version of the emulator does not show the board's ports where they were looked for.");
  return {};
}

void BoardPins::onTrace(const TraceEvent& event) {
  const auto portOf = [this](const std::string& path) {
    return static_cast<std::size_t>(std::ranges::find(portPaths_, path) - portPaths_.begin());
  };
  if (const auto* write = std::get_if<PwmWrite>(&event)) {
    motors_.write(*write);
  } else if (const auto* level = std::get_if<PinLevel>(&event)) {
    if (const std::size_t port = portOf(level->port); port < kPorts)
      onPin(static_cast<Port>(port), level->pin, level->high);
  } else if (const auto* reset = std::get_if<PortReset>(&event)) {
    // Every port says so at a reset of the processor; one of them stands for all.
    if (portOf(reset->port) != A) return;
    levels_ = {};
    motors_.reset();
    wasReset_ = true;
    resets_ = resets_ + 1;
  } else if (const auto* remark = std::get_if<Remark>(&event); remark != nullptr && !isHabitual(remark->text)) {
    lastRemark_ = remark->text;
  }
}

Result<void> BoardPins::begin(QemuLink& link, const Signals& signals) {
  signals_ = signals;
  shown_ = signals_.encoderCounts;
  resets_ = 0;
  return showAllInputs(link);
}

Result<void> BoardPins::serve(QemuLink& link, const Signals& signals) {
  signals_ = signals;
  if (wasReset_) {
    if (auto shown = showAllInputs(link); !shown) return shown;
  }
  if (auto shown = showRadioReady(link); !shown) return shown;
  showField(link);
  if (auto stepped = stepEncoders(link); !stepped) return stepped;
  return serveEchoes(link);
}

Seconds BoardPins::rest(Seconds now) const {
  constexpr Seconds kBetweenSteps{20e-6};
  Seconds rest = shown_ != signals_.encoderCounts ? kBetweenSteps : nextField_ - now;
  for (const EchoSource& echo : echoes_) {
    if (echo.nextEdge()) rest = std::min(rest, *echo.nextEdge() - pinDelay_ - now);
  }
  return std::max(rest, Seconds{});
}

void BoardPins::onPin(Port port, unsigned pin, bool high) {
  const unsigned before = levels_[port];
  levels_[port] = high ? before | 1U << pin : before & ~(1U << pin);
  if (port == C) {
    for (std::size_t i = 0; i < 2; ++i) {
      if (pin == kDirectionPin[i]) motors_.setBackwards(i, high);
    }
  }
  if (port == D && !high && before != levels_[port]) {
    for (std::size_t i = 0; i < firmware::kRangers; ++i) {
      if (pin == kTriggerPin[i]) echoes_[i].triggerFell(monotonicNow(), signals_.range[i]);
    }
  }
}

std::string BoardPins::pinCommand(Port port, unsigned pin, bool high) const {
  return "set_irq_in " + portPaths_[port] + " unnamed-gpio-in " + std::to_string(pin) + (high ? " 1" : " 0");
}

std::vector<std::string> BoardPins::encoderCommands(std::size_t wheel, unsigned before, unsigned levels) const {
  std::vector<std::string> commands;
  for (unsigned channel = 0; channel < 2; ++channel) {
    const unsigned bit = 1U << channel;
    if (((before ^ levels) & bit) != 0)
      commands.push_back(pinCommand(A, kEncoderPin[wheel] + channel, (levels & bit) != 0));
  }
  return commands;
}

Result<void> BoardPins::showAllInputs(QemuLink& link) {
  wasReset_ = false;
  counting_ = false;
  for (EchoSource& echo : echoes_) echo.reset();
  std::vector<std::string> commands;
  for (std::size_t wheel = 0; wheel < 2; ++wheel) {
    const unsigned levels = encoderLevels(shown_[wheel]);
    const auto all = encoderCommands(wheel, ~levels, levels);
    commands.insert(commands.end(), all.begin(), all.end());
  }
  for (unsigned pin : kEchoPin) commands.push_back(pinCommand(D, pin, false));
  shownReady_ = signals_.radioReady;
  commands.push_back(pinCommand(E, kAuxPin, shownReady_));
  if (auto shown = link.pins(commands); !shown) return passOn(shown);
  return {};
}

Result<void> BoardPins::showRadioReady(QemuLink& link) {
  if (signals_.radioReady == shownReady_) return {};
  shownReady_ = signals_.radioReady;
  if (auto shown = link.pins({pinCommand(E, kAuxPin, shownReady_)}); !shown) return passOn(shown);
  return {};
}

void BoardPins::showField(QemuLink& link) {
  const Seconds at = monotonicNow();
  if (at < nextField_) return;
  nextField_ = at + kFieldPeriod;
  if (link.controlUnderWay() > 0) return;  // busy: the next look sees a fresher field
  const bool noiseToo = ++fieldLooks_ % kNoiseEvery == 0;
  static constexpr std::array<const char*, 3> kAxes = {"mag-x", "mag-y", "mag-z"};
  for (std::size_t i = 0; i < 3; ++i) {
    const double field = std::clamp(signals_.field[i], 0.0, kFieldMost);
    if (std::abs(field - shownField_[i]) < (noiseToo ? kFieldStep : kFieldTurn)) continue;
    shownField_[i] = field;
    link.controlLater("qom-set", {{"path", "/machine/peripheral/compass"},
                                  {"property", kAxes[i]},
                                  {"value", static_cast<std::int64_t>(std::lround(field * 1000.0))}});
  }
}

Result<void> BoardPins::stepEncoders(QemuLink& link) {
  if (shown_ == signals_.encoderCounts) return {};
  // An edge is given when the interrupt of the one before was cleared: the emulated processor may stand still for
  // milliseconds when the computer is busy, which no real one does, and would miss edges that no real one misses.
  if (!counting_) {
    const auto mask = readWord(link, kInterruptMask);
    if (!mask) return passOn(mask);
    counting_ = (*mask & kEncoderMask) == kEncoderMask;
  }
  std::uint64_t pending = 0;
  if (counting_) {
    const auto status = readWord(link, kRawInterruptStatus);
    if (!status) return passOn(status);
    pending = *status;
  }
  std::vector<std::string> commands;
  for (std::size_t wheel = 0; wheel < 2; ++wheel) {
    const std::int64_t target = signals_.encoderCounts[wheel];
    if (shown_[wheel] == target) continue;
    if (counting_ && (pending & 3ULL << kEncoderPin[wheel]) != 0) continue;
    const unsigned before = encoderLevels(shown_[wheel]);
    // Nobody counts while the firmware starts: the wheel's turning then is lost to it, as on any vehicle.
    shown_[wheel] = counting_ ? shown_[wheel] + (target > shown_[wheel] ? 1 : -1) : target;
    const auto edges = encoderCommands(wheel, before, encoderLevels(shown_[wheel]));
    commands.insert(commands.end(), edges.begin(), edges.end());
  }
  if (!commands.empty()) {
    if (auto shown = link.pins(commands); !shown) return passOn(shown);
  }
  return {};
}

Result<void> BoardPins::serveEchoes(QemuLink& link) {
  // An order to the emulator takes effect about half way between sending it and its answer: it is sent that much
  // early, and the pulse's length counts from there.
  constexpr Seconds kMostDelay{300e-6};
  for (std::size_t i = 0; i < firmware::kRangers; ++i) {
    const auto due = echoes_[i].nextEdge();
    const Seconds sent = monotonicNow();
    if (!due || *due - pinDelay_ > sent) continue;
    if (auto shown = link.pins({pinCommand(D, kEchoPin[i], echoes_[i].nextLevel())}); !shown) return passOn(shown);
    const Seconds half = 0.5 * (monotonicNow() - sent);
    echoes_[i].changed(sent + half);
    pinDelay_ = std::min(0.8 * pinDelay_ + 0.2 * half, kMostDelay);
  }
  return {};
}

}  // namespace tessera::sim
