#include "sim/qemu/qemu_host.h"

#include <array>
#include <fstream>
#include <string_view>

#include "sim/qemu/qemu_session.h"

namespace tessera::sim {

QemuHost::QemuHost(QemuConfig config) : config_{std::move(config)} {}
QemuHost::~QemuHost() = default;

Result<void> QemuHost::start(Seconds) {
  if (running()) return {};
  session_.reset();
  std::ifstream program{config_.program, std::ios::binary};
  if (!program) return failure("The firmware '" + config_.program + "' cannot be read; './dev build' makes it.");
  std::array<char, 4> magic{};
  program.read(magic.data(), magic.size());
  if (std::string_view{magic.data(), magic.size()} !=
      "\x7F"
      "ELF")
    return failure("The firmware '" + config_.program + "' is no ELF program.");
  session_ = std::make_unique<Session>(config_, signals_);
  return session_->ready();
}

void QemuHost::kill() { session_.reset(); }
bool QemuHost::running() const { return session_ && session_->running(); }

void QemuHost::setSignals(const Signals& signals) {
  signals_ = signals;
  if (session_) session_->set(signals);
}

void QemuHost::fromRadio(std::span<const std::uint8_t> bytes) {
  if (session_) session_->send(firmware::Uart::Radio, bytes);
}

void QemuHost::fromReaders(std::span<const std::uint8_t> bytes) {
  if (session_) session_->send(firmware::Uart::Readers, bytes);
}

void QemuHost::advance(Seconds) {}

Actions QemuHost::take() { return session_ ? session_->take() : Actions{}; }

std::string QemuHost::trouble() const {
  if (!session_) return "The emulated vehicle is switched off.";
  return session_->running() ? std::string{} : session_->trouble();
}

int QemuHost::resets() const { return session_ ? session_->resets() : 0; }
int QemuHost::processId() const { return session_ ? session_->processId() : 0; }

}  // namespace tessera::sim
