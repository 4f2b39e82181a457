#include "sim/native_host.h"

#include <algorithm>
#include <cmath>

namespace tessera::sim {
namespace {

constexpr std::uint64_t kBoardPollPeriod = 1000;  // µs
constexpr std::uint64_t kTickPeriod = 10'000;     // µs

std::uint64_t microsOf(Seconds t) { return static_cast<std::uint64_t>(std::llround(std::max(0.0, t.value()) * 1e6)); }

}  // namespace

void NativeHost::boot(wire::ResetCause cause) {
  board_.powerOn(board_.now(), cause);
  nextTick_ = board_.now() + kTickPeriod;
  vehicle_.emplace(board_);
  ++starts_;
}

Result<void> NativeHost::start(Seconds now) {
  board_.advanceTo(microsOf(now));
  boot(wire::ResetCause::PowerOn);
  return {};
}

void NativeHost::kill() {
  vehicle_.reset();
  // Pins and wires fall silent; the EEPROM keeps what it holds.
  board_.powerOn(board_.now(), wire::ResetCause::PowerOn);
}

void NativeHost::setSignals(const Signals& signals) {
  firmware::HostInputs inputs;
  inputs.encoderCounts = signals.encoderCounts;
  inputs.field = signals.field;
  for (std::size_t i = 0; i < inputs.range.size(); ++i) inputs.range[i] = signals.range[i].value();
  inputs.radioReady = signals.radioReady;
  board_.setInputs(inputs);
}

void NativeHost::fromRadio(std::span<const std::uint8_t> bytes) {
  if (vehicle_) board_.receive(firmware::Uart::Radio, bytes);
}

void NativeHost::fromReaders(std::span<const std::uint8_t> bytes) {
  if (vehicle_) board_.receive(firmware::Uart::Readers, bytes);
}

void NativeHost::advance(Seconds now) {
  const std::uint64_t target = microsOf(now);
  while (vehicle_ && board_.now() < target) {
    board_.advanceTo(std::min(target, board_.now() + kBoardPollPeriod));
    vehicle_->poll();
    if (board_.now() >= nextTick_) {
      vehicle_->tick();
      // Ticks that were missed are not made up for, as the timer's interrupts merge on the chip.
      while (nextTick_ <= board_.now()) nextTick_ += kTickPeriod;
    }
    if (board_.restartDue()) boot(board_.nextCause());
  }
}

Actions NativeHost::take() {
  Actions actions;
  if (!vehicle_) return actions;
  actions.duty = board_.duty();
  actions.radioMode = board_.radioMode();
  actions.toRadio = board_.takeSent(firmware::Uart::Radio);
  actions.toReaders = board_.takeSent(firmware::Uart::Readers);
  return actions;
}

}  // namespace tessera::sim
