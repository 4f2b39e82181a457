#include "firmware/boards/host/host_board.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tessera::firmware {
namespace {

constexpr std::uint32_t kResetBaud = 9600;
constexpr double kEchoPerMetre = 5800.0;  // µs there and back: the 58 µs/cm of the HC-SR04's data sheet
constexpr std::uint64_t kBurst = 450;  // µs from the trigger to the rising echo: eight periods of 40 kHz and settling
constexpr double kFarthest = 4.0;      // m
constexpr std::uint32_t kOpen = 38'000;     // µs: the pulse when nothing is in reach (its data sheet)
constexpr std::uint64_t kI2cByteTime = 23;  // µs, nine bits at 400 kHz, rounded up

}  // namespace

HostBoard::HostBoard(const EepromChip::Image& eeprom) : eeprom_{eeprom} { powerOn(0, wire::ResetCause::PowerOn); }

void HostBoard::powerOn(std::uint64_t now, wire::ResetCause cause) {
  now_ = std::max(now_, now);
  startedAt_ = now_;
  fedAt_ = now_;
  cause_ = cause;
  restartAsked_ = false;
  countsAtStart_ = inputs_.encoderCounts;
  duty_ = {};
  echoes_ = {};
  radioMode_ = RadioMode::Normal;
  for (const Uart which : {Uart::Radio, Uart::Readers}) setBaud(which, kResetBaud);
  compass_.powerOn(now_);
  eeprom_.powerOn();
}

void HostBoard::setInputs(const HostInputs& inputs) { inputs_ = inputs; }

void HostBoard::advanceTo(std::uint64_t now) {
  now_ = std::max(now_, now);
  compass_.step(now_, inputs_.field);
}

void HostBoard::receive(Uart which, std::span<const std::uint8_t> bytes) {
  // A full ring loses what comes, as the chip's receiver does.
  for (const std::uint8_t byte : bytes) port(which).in.pushEnded(byte, nanos());
}

void HostBoard::collectSent(Port& from) {
  std::uint8_t byte = 0;
  while (from.out.pop(byte, nanos())) from.left.push_back(byte);
}

std::vector<std::uint8_t> HostBoard::takeSent(Uart which) {
  collectSent(port(which));
  return std::exchange(port(which).left, {});
}

wire::ResetCause HostBoard::nextCause() const {
  return restartAsked_ ? wire::ResetCause::Software : wire::ResetCause::Watchdog;
}

std::uint32_t HostBoard::micros() {
  // Asking takes time too: a loop that waits for the clock comes to its end.
  return static_cast<std::uint32_t>(now_++ - startedAt_);
}

std::size_t HostBoard::read(Uart which, std::span<std::uint8_t> out) {
  std::size_t count = 0;
  while (count < out.size() && port(which).in.pop(out[count], nanos())) ++count;
  return count;
}

std::size_t HostBoard::write(Uart which, std::span<const std::uint8_t> data) {
  if (restartAsked_) return data.size();
  std::size_t count = 0;
  while (count < data.size() && port(which).out.push(data[count], nanos())) ++count;
  return count;
}

bool HostBoard::sent(Uart which) { return port(which).out.idle(nanos()); }

void HostBoard::setBaud(Uart which, std::uint32_t baud) {
  collectSent(port(which));
  const std::uint64_t byteTime = 10'000'000'000ULL / std::max<std::uint32_t>(baud, 1);
  for (PacedQueue* queue : {&port(which).in, &port(which).out}) {
    queue->clear();
    queue->setByteTime(byteTime);
  }
}

void HostBoard::setRadioMode(RadioMode mode) {
  if (!restartAsked_) radioMode_ = mode;
}

void HostBoard::spendOnI2c(std::size_t bytes) { now_ += kI2cByteTime * (bytes + 1); }

bool HostBoard::i2cWrite(std::uint8_t address, std::span<const std::uint8_t> data) {
  spendOnI2c(data.size());
  if (restartAsked_) return false;
  if (address == CompassChip::kAddress && compassPresent_) return compass_.write(data, now_);
  if (address == EepromChip::kAddress && eepromPresent_) return eeprom_.write(data, now_);
  return false;
}

bool HostBoard::i2cRead(std::uint8_t address, std::span<std::uint8_t> out) {
  spendOnI2c(out.size());
  if (address == CompassChip::kAddress && compassPresent_) return compass_.read(out);
  if (address == EepromChip::kAddress && eepromPresent_) return eeprom_.read(out, now_);
  return false;
}

void HostBoard::drive(Wheel wheel, std::int16_t permille) {
  if (restartAsked_) return;
  duty_[static_cast<std::size_t>(wheel)] = std::clamp<int>(permille, -1000, 1000);
}

std::int32_t HostBoard::counts(Wheel wheel) {
  const auto i = static_cast<std::size_t>(wheel);
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(inputs_.encoderCounts[i] - countsAtStart_[i]));
}

void HostBoard::ping(std::size_t ranger) {
  if (ranger >= echoes_.size()) return;
  const double range = inputs_.range[ranger];
  echoes_[ranger] = {};
  if (std::isnan(range)) return;
  const bool open = range <= 0.0 || range > kFarthest;
  const auto length = open ? kOpen : static_cast<std::uint32_t>(std::lround(range * kEchoPerMetre));
  echoes_[ranger] = {now_ + kBurst + length, length};
}

std::uint32_t HostBoard::echo(std::size_t ranger) {
  if (ranger >= echoes_.size() || now_ < echoes_[ranger].end) return 0;
  return echoes_[ranger].length;
}

}  // namespace tessera::firmware
