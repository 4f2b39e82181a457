#include "sim/e32.h"

#include <algorithm>

namespace tessera::sim {

using firmware::RadioMode;

namespace {

constexpr std::array<int, 8> kBauds{1200, 2400, 4800, 9600, 19200, 38400, 57600, 115200};
constexpr int kConfigureBaud = 9600;
constexpr double kSilence = 3;           // byte times after which a short packet leaves
constexpr Seconds kBeforeOutput{0.005};  // AUX low before received bytes leave
constexpr Seconds kModeChange{0.001};    // once the module is idle
constexpr Seconds kBeforeAnswer{0.005};  // to a command; the data sheet is silent, the same as for received bytes
constexpr std::uint16_t kEverybody = 0xFFFF;
constexpr std::uint8_t kFixedBit = 0x80;
constexpr std::array<std::uint8_t, 4> kVersion{0xC3, 0x32, 0x27, 0x02};  // 433 MHz, as a module of 2018 answers

constexpr std::uint8_t kWriteAndSave = 0xC0;
constexpr std::uint8_t kRead = 0xC1;
constexpr std::uint8_t kWrite = 0xC2;
constexpr std::uint8_t kAskVersion = 0xC3;
constexpr std::uint8_t kReset = 0xC4;

}  // namespace

E32Registers E32Registers::of(int channel, int airRate, int baud) {
  E32Registers r;
  const auto* const found = std::find(kBauds.begin(), kBauds.end(), baud);
  const auto rate = found == kBauds.end() ? 3 : found - kBauds.begin();
  r.bytes[2] = static_cast<std::uint8_t>((rate << 3) | std::clamp(airRate, 0, kAirRates - 1));
  r.bytes[3] = static_cast<std::uint8_t>(channel & 0x1F);
  return r;
}

std::uint16_t E32Registers::address() const { return static_cast<std::uint16_t>((bytes[0] << 8) | bytes[1]); }
int E32Registers::baud() const { return kBauds[(bytes[2] >> 3) & 7U]; }
Tuning E32Registers::tuning() const { return {bytes[3] & 0x1F, std::min(bytes[2] & 7, kAirRates - 1)}; }

E32::E32(Air& air, const E32Registers& stored, Seconds handover)
    : air_{air}, module_{air.join()}, handover_{handover}, saved_{stored}, working_{stored} {
  listen(now_);
}

Seconds E32::byteTime() const {
  return Seconds{10.0 / (mode_ == RadioMode::Configure ? kConfigureBaud : working_.baud())};
}

void E32::listen(Seconds now) {
  const bool hears = powered_ && mode_ == RadioMode::Normal;
  air_.tune(module_, hears ? std::optional{working_.tuning()} : std::nullopt, now);
}

void E32::fromUart(std::span<const std::uint8_t> bytes, Seconds now) {
  if (!powered_) return;
  if (wanted_) {
    counters_.deaf += bytes.size();
    return;
  }
  wireFree_ = std::max(wireFree_, now);
  for (const std::uint8_t byte : bytes) {
    wireFree_ += byteTime();
    wire_.push_back({byte, wireFree_});
  }
}

void E32::setMode(RadioMode mode, Seconds now) {
  if (!powered_ || mode == wanted_.value_or(mode_)) return;
  wanted_ = mode;
  wantedSince_ = now;
}

void E32::advance(Seconds now) {
  while (powered_ && runOne(now)) {
  }
  now_ = now;
}

/// The earliest thing due by `now`; false when there is none.
bool E32::runOne(Seconds now) {
  const auto due = packetDue();
  if (!wire_.empty() && wire_.front().at <= now && (!due || wire_.front().at <= *due)) {
    const Timed byte = wire_.front();
    wire_.pop_front();
    arrive(byte);
    return true;
  }
  if (due && *due <= now) {
    startPacket(*due);
    return true;
  }
  return changeMode(now);
}

std::optional<Seconds> E32::packetDue() const {
  if (buffer_.empty()) return std::nullopt;
  const Seconds silence = std::max(kSilence * byteTime(), handover_ + byteTime());
  const Seconds complete = buffer_.size() >= kPacket ? buffer_[kPacket - 1].at : buffer_.back().at + silence;
  return std::max(complete, airFree_);
}

void E32::arrive(const Timed& byte) {
  if (mode_ == RadioMode::Configure) {
    command(byte);
  } else if (mode_ != RadioMode::Normal) {
    ++counters_.deaf;
  } else if (buffer_.size() >= kBuffer) {
    ++counters_.overflow;
  } else {
    buffer_.push_back(byte);
  }
}

void E32::startPacket(Seconds at) {
  const std::size_t size = std::min(buffer_.size(), kPacket);
  std::vector<std::uint8_t> bytes;
  bytes.reserve(size);
  for (std::size_t i = 0; i < size; ++i) bytes.push_back(buffer_[i].byte);
  buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(size));
  airFree_ = air_.transmit(module_, working_.tuning(), working_.address(), bytes, at);
  ++counters_.sent;
}

void E32::command(const Timed& byte) {
  command_.push_back(byte.byte);
  const std::uint8_t head = command_.front();
  const bool writes = head == kWriteAndSave || head == kWrite;
  const bool asks = head == kRead || head == kAskVersion || head == kReset;
  // A question is its byte three times; anything else at its place starts anew.
  if (!writes && !(asks && byte.byte == head)) {
    command_.clear();
    return;
  }
  if (command_.size() < (writes ? 1 + working_.bytes.size() : 3)) return;
  if (writes) {
    std::copy(command_.begin() + 1, command_.end(), working_.bytes.begin());
    working_.bytes[4] &= static_cast<std::uint8_t>(~kFixedBit);
    if (head == kWriteAndSave) saved_ = working_;
  }
  if (head == kReset) working_ = saved_;
  command_.clear();
  if (head == kReset) return;
  if (head == kAskVersion) return answer(kVersion, byte.at);
  std::array<std::uint8_t, 6> text{kWriteAndSave};
  std::copy(working_.bytes.begin(), working_.bytes.end(), text.begin() + 1);
  answer(text, byte.at);
}

void E32::answer(std::span<const std::uint8_t> bytes, Seconds from) {
  outputFree_ = std::max(outputFree_, from + kBeforeAnswer);
  for (const std::uint8_t byte : bytes) {
    outputFree_ += byteTime();
    output_.push_back({byte, outputFree_});
  }
}

/// A change waits until everything handed over before has been sent and everything received has left.
bool E32::changeMode(Seconds now) {
  if (!wanted_ || !wire_.empty() || !buffer_.empty()) return false;
  const Seconds idle = std::max({wantedSince_, airFree_, outputFree_, wireFree_});
  const Seconds done = idle + kModeChange;
  if (done > now) return false;
  mode_ = *wanted_;
  wanted_.reset();
  command_.clear();
  listen(done);
  return true;
}

std::vector<std::uint8_t> E32::takeUart(Seconds now) {
  std::vector<std::uint8_t> out;
  while (!output_.empty() && output_.front().at <= now) {
    out.push_back(output_.front().byte);
    output_.pop_front();
  }
  return out;
}

bool E32::ready() const {
  return powered_ && !wanted_ && wire_.empty() && buffer_.empty() && outputFree_ <= now_ && now_ >= wireFree_;
}

void E32::receive(const Packet& packet, Seconds at) {
  const bool same =
      packet.address == working_.address() || packet.address == kEverybody || working_.address() == kEverybody;
  if (!powered_ || mode_ != RadioMode::Normal || !same) return;
  if (output_.size() + packet.bytes.size() > kBuffer) {
    counters_.overflow += packet.bytes.size();
    return;
  }
  ++counters_.received;
  outputFree_ = std::max(outputFree_, at + kBeforeOutput);
  for (const std::uint8_t byte : packet.bytes) {
    outputFree_ += byteTime();
    output_.push_back({byte, outputFree_});
  }
}

void E32::setPowered(bool powered, Seconds now) {
  if (powered == powered_) return;
  powered_ = powered;
  air_.breakOff(module_);
  working_ = saved_;
  mode_ = RadioMode::Normal;
  wanted_.reset();
  wire_.clear();
  buffer_.clear();
  output_.clear();
  command_.clear();
  wireFree_ = airFree_ = outputFree_ = now_ = now;
  listen(now);
}

}  // namespace tessera::sim
