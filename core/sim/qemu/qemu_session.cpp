#include "sim/qemu/qemu_session.h"

#include <sys/prctl.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

namespace tessera::sim {
namespace {

constexpr std::array<std::uint64_t, 4> kPortAddresses = {0x40004000, 0x40006000, 0x40007000, 0x40024000};
constexpr unsigned kEncoderMask = 0x3C;                                   // port A
constexpr std::array<unsigned, 2> kEncoderPin = {2, 4};                   // port A: channel A; B is the next one
constexpr std::array<unsigned, 2> kDirectionPin = {4, 5};                 // port C
constexpr std::array<unsigned, firmware::kRangers> kTriggerPin = {4, 6};  // port D
constexpr std::array<unsigned, firmware::kRangers> kEchoPin = {5, 7};     // port D
constexpr unsigned kAuxPin = 2;                                           // port E

constexpr Seconds kFieldPeriod{1.0 / 75.0};  // the compass' own fastest rate
constexpr double kFieldStep = 0.05;          // µT: half of the compass' resolution
constexpr double kFieldMost = 186.0;         // µT: beyond, and below 0, the emulated compass takes no values

Seconds now() {
  return Seconds{std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count()};
}

template <class T>
tl::unexpected<Error> passOn(const Result<T>& r) {
  return tl::unexpected<Error>{r.error()};
}

}  // namespace

QemuHost::Session::Session(const QemuConfig& config, const Signals& signals) : config_{config}, newSignals_{signals} {
  thread_ = std::thread{[this] { run(); }};
}

QemuHost::Session::~Session() {
  stop_ = true;
  {
    const std::lock_guard lock{linkMutex_};
    if (link_) link_->wake();
  }
  thread_.join();
}

Result<void> QemuHost::Session::ready() {
  auto opened = opened_.get_future();
  if (opened.wait_for(std::chrono::duration<double>(config_.startLimit.value())) != std::future_status::ready)
    return failure("The emulated board did not start within " + std::to_string(config_.startLimit.value()) + " s.");
  return opened.get();
}

void QemuHost::Session::set(const Signals& signals) {
  bool urgent = false;
  {
    const std::lock_guard lock{mutex_};
    urgent = signals.encoderCounts != newSignals_.encoderCounts || signals.radioReady != newSignals_.radioReady;
    newSignals_ = signals;
  }
  if (!urgent) return;  // the field is shown at its own rate, ranges when they are asked for
  const std::lock_guard lock{linkMutex_};
  if (link_) link_->wake();
}

void QemuHost::Session::send(firmware::Uart port, std::span<const std::uint8_t> bytes) {
  {
    const std::lock_guard lock{mutex_};
    auto& queue = port == firmware::Uart::Radio ? radioIn_ : readersIn_;
    queue.insert(queue.end(), bytes.begin(), bytes.end());
  }
  const std::lock_guard lock{linkMutex_};
  if (link_) link_->wake();
}

Actions QemuHost::Session::take() {
  const std::lock_guard lock{mutex_};
  Actions taken = actions_;
  actions_.toRadio.clear();
  actions_.toReaders.clear();
  return taken;
}

std::string QemuHost::Session::trouble() const {
  const std::lock_guard lock{mutex_};
  return trouble_;
}

void QemuHost::Session::run() {
  ::prctl(PR_SET_TIMERSLACK, 1000UL);  // ns: echoes are timed here
  auto outcome = open();
  running_ = outcome.has_value();
  opened_.set_value(outcome);
  if (outcome) outcome = serve();
  running_ = false;
  process_.end();
  processId_ = 0;
  const std::lock_guard lock{mutex_};
  actions_.duty = {};
  if (!outcome) trouble_ = outcome.error().sentence;
}

Result<void> QemuHost::Session::open() {
  if (auto file = prepareEeprom(config_.eeprom); !file) return file;
  auto wires = process_.start(config_.emulator, config_.program, config_.eeprom);
  if (!wires) return passOn(wires);
  processId_ = process_.id();
  {
    const std::lock_guard lock{linkMutex_};
    link_.emplace(std::move(*wires), [this](const TraceEvent& event) { onTrace(event); });
  }
  if (auto greeted = link_->control("qmp_capabilities", {}); !greeted)
    return failure(withReason(greeted.error().sentence));
  if (auto found = findPorts(); !found) return found;
  takeOver();
  shown_ = signals_.encoderCounts;
  if (auto shown = showAllInputs(); !shown) return shown;
  wasReset_ = false;
  resets_ = 0;
  if (auto going = link_->control("cont", {}); !going) return passOn(going);
  return {};
}

Result<void> QemuHost::Session::findPorts() {
  const auto children = link_->control("qom-list", {{"path", "/machine/unattached"}});
  if (!children) return passOn(children);
  for (const auto& child : *children) {
    if (child.value("type", "").find("pl061") == std::string::npos) continue;
    const std::string path = "/machine/unattached/" + child.value("name", "");
    const auto address = link_->control("qom-get", {{"path", path + "/pl061[0]"}, {"property", "addr"}});
    if (!address) return passOn(address);
    for (std::size_t i = 0; i < kPorts; ++i) {
      if (address->is_number_unsigned() && address->get<std::uint64_t>() == kPortAddresses[i]) portPaths_[i] = path;
    }
  }
  if (std::ranges::any_of(portPaths_, &std::string::empty))
    return failure("This version of the emulator does not show the board's ports where they were looked for.");
  return {};
}

Result<void> QemuHost::Session::serve() {
  while (!stop_) {
    takeOver();
    if (wasReset_) {
      wasReset_ = false;
      if (auto shown = showAllInputs(); !shown) return failure(withReason(shown.error().sentence));
    }
    if (auto shown = showRadioReady(); !shown) return failure(withReason(shown.error().sentence));
    showField(now());
    const auto stepsDue = stepEncoders();
    if (!stepsDue) return failure(withReason(stepsDue.error().sentence));
    if (auto served = serveEchoes(); !served) return failure(withReason(served.error().sentence));
    publish();
    if (!link_->pump(restUntilNextWork(now(), *stepsDue)))
      return failure(withReason("The emulator of the vehicle has ended."));
    publish();
  }
  return {};
}

void QemuHost::Session::takeOver() {
  std::vector<std::uint8_t> radio, readers;
  {
    const std::lock_guard lock{mutex_};
    signals_ = newSignals_;
    radio.swap(radioIn_);
    readers.swap(readersIn_);
  }
  if (!radio.empty()) link_->sendRadio(radio);
  if (!readers.empty()) link_->sendReaders(readers);
}

void QemuHost::Session::publish() {
  const std::vector<std::uint8_t> radio = link_->takeRadio();
  const std::vector<std::uint8_t> readers = link_->takeReaders();
  const std::lock_guard lock{mutex_};
  actions_.duty = {motors_.duty(0), motors_.duty(1)};
  actions_.radioMode = static_cast<firmware::RadioMode>(levels_[E] & 3U);
  actions_.toRadio.insert(actions_.toRadio.end(), radio.begin(), radio.end());
  actions_.toReaders.insert(actions_.toReaders.end(), readers.begin(), readers.end());
}

void QemuHost::Session::onTrace(const TraceEvent& event) {
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
  } else if (const auto* remark = std::get_if<Remark>(&event); remark != nullptr && !remark->text.empty()) {
    lastRemark_ = remark->text;
  }
}

void QemuHost::Session::onPin(Port port, unsigned pin, bool high) {
  const unsigned before = levels_[port];
  levels_[port] = high ? before | 1U << pin : before & ~(1U << pin);
  if (port == C) {
    for (std::size_t i = 0; i < 2; ++i) {
      if (pin == kDirectionPin[i]) motors_.setBackwards(i, high);
    }
  }
  if (port == D && !high && before != levels_[port]) {
    for (std::size_t i = 0; i < firmware::kRangers; ++i) {
      if (pin == kTriggerPin[i]) echoes_[i].triggerFell(now(), signals_.range[i]);
    }
  }
}

std::string QemuHost::Session::pinCommand(Port port, unsigned pin, bool high) const {
  return "set_irq_in " + portPaths_[port] + " unnamed-gpio-in " + std::to_string(pin) + (high ? " 1" : " 0");
}

std::vector<std::string> QemuHost::Session::encoderCommands(std::size_t wheel, unsigned before, unsigned levels) const {
  std::vector<std::string> commands;
  for (unsigned channel = 0; channel < 2; ++channel) {
    const unsigned bit = 1U << channel;
    if (((before ^ levels) & bit) != 0)
      commands.push_back(pinCommand(A, kEncoderPin[wheel] + channel, (levels & bit) != 0));
  }
  return commands;
}

Result<void> QemuHost::Session::showAllInputs() {
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
  if (auto shown = link_->pins(commands); !shown) return passOn(shown);
  return {};
}

Result<void> QemuHost::Session::showRadioReady() {
  if (signals_.radioReady == shownReady_) return {};
  shownReady_ = signals_.radioReady;
  if (auto shown = link_->pins({pinCommand(E, kAuxPin, shownReady_)}); !shown) return passOn(shown);
  return {};
}

void QemuHost::Session::showField(Seconds at) {
  if (at < nextField_ || link_->controlUnderWay() > 0) return;
  nextField_ = at + kFieldPeriod;
  static constexpr std::array<const char*, 3> kAxes = {"mag-x", "mag-y", "mag-z"};
  for (std::size_t i = 0; i < 3; ++i) {
    const double field = std::clamp(signals_.field[i], 0.0, kFieldMost);
    if (std::abs(field - shownField_[i]) < kFieldStep) continue;
    shownField_[i] = field;
    link_->controlLater("qom-set", {{"path", "/machine/peripheral/compass"},
                                    {"property", kAxes[i]},
                                    {"value", static_cast<std::int64_t>(std::lround(field * 1000.0))}});
  }
}

Result<bool> QemuHost::Session::stepEncoders() {
  if (shown_ == signals_.encoderCounts) return false;
  // An edge is given when the interrupt of the one before was cleared: the emulated processor may stand still for
  // milliseconds when the computer is busy, which no real one does, and would miss edges that no real one misses.
  const auto status = link_->pins({"readl 0x40004410", "readl 0x40004414"});
  if (!status) return passOn(status);
  const auto word = [](const std::string& answer) {
    return std::stoul(answer.substr(answer.find(' ') + 1), nullptr, 16);
  };
  counting_ = (word((*status)[0]) & kEncoderMask) == kEncoderMask;
  const unsigned long pending = word((*status)[1]);
  std::vector<std::string> commands;
  for (std::size_t wheel = 0; wheel < 2; ++wheel) {
    const std::int64_t target = signals_.encoderCounts[wheel];
    if (shown_[wheel] == target) continue;
    if (counting_ && (pending & 3UL << kEncoderPin[wheel]) != 0) continue;
    const unsigned before = encoderLevels(shown_[wheel]);
    // Nobody counts while the firmware starts: the wheel's turning then is lost to it, as on any vehicle.
    shown_[wheel] = counting_ ? shown_[wheel] + (target > shown_[wheel] ? 1 : -1) : target;
    const auto edges = encoderCommands(wheel, before, encoderLevels(shown_[wheel]));
    commands.insert(commands.end(), edges.begin(), edges.end());
  }
  if (!commands.empty()) {
    if (auto shown = link_->pins(commands); !shown) return passOn(shown);
  }
  return shown_ != signals_.encoderCounts;
}

Result<void> QemuHost::Session::serveEchoes() {
  // An order to the emulator takes effect about half way between sending it and its answer: it is sent that much
  // early, and the pulse's length counts from there.
  constexpr Seconds kMostDelay{300e-6};
  for (std::size_t i = 0; i < firmware::kRangers; ++i) {
    const auto due = echoes_[i].nextEdge();
    const Seconds sent = now();
    if (!due || *due - pinDelay_ > sent) continue;
    if (auto shown = link_->pins({pinCommand(D, kEchoPin[i], echoes_[i].nextLevel())}); !shown) return passOn(shown);
    const Seconds half = 0.5 * (now() - sent);
    echoes_[i].changed(sent + half);
    pinDelay_ = std::min(0.8 * pinDelay_ + 0.2 * half, kMostDelay);
  }
  return {};
}

Seconds QemuHost::Session::restUntilNextWork(Seconds at, bool stepsDue) const {
  constexpr Seconds kBetweenSteps{20e-6};
  Seconds rest = stepsDue ? kBetweenSteps : nextField_ - at;
  for (const EchoSource& echo : echoes_) {
    if (echo.nextEdge()) rest = std::min(rest, *echo.nextEdge() - pinDelay_ - at);
  }
  return std::max(rest, Seconds{});
}

std::string QemuHost::Session::withReason(const std::string& sentence) const {
  return lastRemark_.empty() ? sentence : sentence + " It said: " + lastRemark_;
}

}  // namespace tessera::sim
