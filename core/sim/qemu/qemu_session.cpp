#include "sim/qemu/qemu_session.h"

#include <sys/prctl.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "sim/qemu/monotonic.h"

namespace tessera::sim {

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
  process_.end();
  processId_ = 0;
  {
    const std::lock_guard lock{mutex_};
    actions_.duty = {};
    if (!outcome) trouble_ = outcome.error().sentence;
  }
  running_ = false;  // last: whoever sees this finds the reason
}

Result<void> QemuHost::Session::open() {
  if (auto file = prepareEeprom(config_.eeprom); !file) return file;
  auto wires = process_.start(config_.emulator, config_.program, config_.eeprom);
  if (!wires) return passOn(wires);
  processId_ = process_.id();
  {
    const std::lock_guard lock{linkMutex_};
    link_.emplace(std::move(*wires), [this](const TraceEvent& event) { pins_.onTrace(event); });
  }
  if (auto greeted = link_->control("qmp_capabilities", {}); !greeted)
    return failure(withReason(greeted.error().sentence));
  if (auto found = pins_.find(*link_); !found) return found;
  takeOver();
  if (auto shown = pins_.begin(*link_, signals_); !shown) return shown;
  if (auto going = link_->control("cont", {}); !going) return passOn(going);
  return {};
}

Result<void> QemuHost::Session::serve() {
  while (!stop_) {
    takeOver();
    if (auto served = pins_.serve(*link_, signals_); !served) return failure(withReason(served.error().sentence));
    publish();
    if (!link_->pump(pins_.rest(monotonicNow()))) return failure(withReason("The emulator of the vehicle has ended."));
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
  resets_ = pins_.resets();
  const std::lock_guard lock{mutex_};
  actions_.duty = {pins_.duty(0), pins_.duty(1)};
  actions_.radioMode = pins_.radioMode();
  actions_.toRadio.insert(actions_.toRadio.end(), radio.begin(), radio.end());
  actions_.toReaders.insert(actions_.toReaders.end(), readers.begin(), readers.end());
}

std::string QemuHost::Session::withReason(const std::string& sentence) const {
  return pins_.lastRemark().empty() ? sentence : sentence + " It said: " + pins_.lastRemark();
}

}  // namespace tessera::sim
