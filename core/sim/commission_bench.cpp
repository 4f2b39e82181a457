#include "sim/commission_bench.h"

#include <algorithm>

namespace tessera::sim {
namespace {

constexpr Seconds kStep{0.001};
constexpr Seconds kAnswerPatience{0.1};
constexpr Seconds kCommandPeriod{0.1};
constexpr int kHellos = 50;

}  // namespace

void CommissionBench::step() {
  now_ += kStep;
  vehicle_.step(now_);
  const std::vector<std::uint8_t> bytes = vehicle_.takeRadioBytes();
  if (vehicle_.radioMode() == firmware::RadioMode::Configure)
    answerAsModule(bytes);
  else
    decoder_.feed(bytes, [this](const wire::Frame& frame) { take(frame); });
}

// The E32's configuration commands: C1 C1 C1 asks for the registers, C0 or C2 and five bytes sets them; both answer
// with the registers.
void CommissionBench::answerAsModule(std::span<const std::uint8_t> bytes) {
  toModule_.insert(toModule_.end(), bytes.begin(), bytes.end());
  while (!toModule_.empty()) {
    const bool asks = toModule_[0] == 0xC1;
    const bool sets = toModule_[0] == 0xC0 || toModule_[0] == 0xC2;
    const std::ptrdiff_t size = asks ? 3 : sets ? 6 : 1;
    if (toModule_.size() < static_cast<std::size_t>(size)) return;
    if (sets) std::copy_n(toModule_.begin() + 1, 5, moduleRegisters_.begin() + 1);
    if (asks || sets) vehicle_.giveRadioBytes(moduleRegisters_);
    toModule_.erase(toModule_.begin(), toModule_.begin() + size);
  }
}

void CommissionBench::run(Seconds time) {
  const Seconds end = now_ + time - 0.5 * kStep;
  while (now_ < end) step();
}

bool CommissionBench::runUntil(const std::function<bool()>& done, Seconds patience) {
  const Seconds end = now_ + patience;
  while (!done()) {
    if (now_ >= end) return false;
    step();
  }
  return true;
}

void CommissionBench::transmit(wire::MessageType type, const wire::Key& key, std::uint32_t counter, wire::Bytes body) {
  std::array<std::uint8_t, wire::kMaxFrame> frame{};
  const wire::FrameHeader header{vehicle_.id().value, wire::kHostAddress, static_cast<std::uint8_t>(type), 0};
  const std::size_t size = wire::sealFrame(key, counter, header, body, frame);
  lastSent_.assign(frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(size));
  send(lastSent_);
}

bool CommissionBench::fromVehicle(const wire::Frame& frame, const wire::Sealed& sealed) {
  return sessionKey_ && guard_.accept(*sessionKey_, frame.header, sealed.body, sealed.mac) == wire::Refusal::None;
}

void CommissionBench::take(const wire::Frame& frame) {
  const auto sealed = wire::splitMac(frame.payload);
  if (!sealed || frame.header.to != wire::kHostAddress || frame.header.from != vehicle_.id().value) return;
  switch (static_cast<wire::MessageType>(frame.header.type)) {
    case wire::MessageType::Identity: {
      const auto identity = wire::decodeIdentity(sealed->body);
      const bool genuine = wire::sameMac(wire::macOf(key_, 0, frame.header, sealed->body), sealed->mac);
      if (genuine && identity && identity->hostNonce == hostNonce_) identity_ = identity;
      break;
    }
    case wire::MessageType::Report:
      if (fromVehicle(frame, *sealed)) report_ = wire::decodeReport(sealed->body);
      break;
    case wire::MessageType::Value:
      if (fromVehicle(frame, *sealed)) value_ = wire::decodeValue(sealed->body);
      break;
    default:
      break;
  }
}

Result<wire::Identity> CommissionBench::open() {
  identity_.reset();
  sessionKey_.reset();
  for (int i = 0; i < kHellos && !identity_; ++i) {
    std::array<std::uint8_t, 16> body{};
    const std::size_t size = wire::encode(wire::Hello{++hostNonce_, counter_}, body);
    transmit(wire::MessageType::Hello, key_, 0, wire::Bytes{body}.first(size));
    runUntil([this] { return identity_.has_value(); }, kAnswerPatience);
  }
  if (!identity_) return failure("On the bench the vehicle did not answer to Hello.");
  sessionKey_ = wire::deriveSessionKey(key_, {hostNonce_, identity_->boot, identity_->hello});
  guard_ = wire::ReplayGuard{};
  return *identity_;
}

std::optional<wire::Report> CommissionBench::command(const wire::CycleEntry& entry) {
  report_.reset();
  if (!sessionKey_) return report_;
  wire::CycleEntry addressed = entry;
  addressed.vehicle = vehicle_.id().value;
  wire::CycleWriter cycle{0, ++counter_};
  cycle.add(addressed, *sessionKey_);
  std::array<std::uint8_t, wire::kMaxFrame> frame{};
  const std::size_t size = cycle.finish(frame);
  lastSent_.assign(frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(size));
  send(lastSent_);
  runUntil([this] { return report_.has_value(); }, kAnswerPatience);
  return report_;
}

std::optional<wire::Report> CommissionBench::keepCommanding(const wire::CycleEntry& entry, Seconds time) {
  const Seconds end = now_ + time;
  std::optional<wire::Report> last;
  while (now_ < end) {
    const Seconds begun = now_;
    if (const auto report = command(entry)) last = report;
    run(std::min(begun + kCommandPeriod, end) - now_);
  }
  return last;
}

std::optional<wire::Value> CommissionBench::request(const wire::Request& request) {
  value_.reset();
  if (!sessionKey_) return value_;
  std::array<std::uint8_t, 16> body{};
  const std::size_t size = wire::encode(request, body);
  transmit(request.type, *sessionKey_, ++counter_, wire::Bytes{body}.first(size));
  runUntil([this] { return value_.has_value(); }, kAnswerPatience);
  return value_;
}

}  // namespace tessera::sim
