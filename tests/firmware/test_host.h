// The host's side of one conversation, for tests: it knows the vehicle's key and speaks the wire, nothing more.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "wire/messages.h"
#include "wire/pairing.h"

namespace tessera::firmware::test {

class TestHost {
public:
  using Frame = std::vector<std::uint8_t>;

  TestHost(std::uint8_t vehicle, const wire::Key& key) : vehicle_{vehicle}, key_{key} {}

  Frame hello(std::uint32_t nonce) {
    nonce_ = nonce;
    std::array<std::uint8_t, 8> body;
    encode(wire::Hello{nonce, counter_}, body);
    return sealed(key_, 0, wire::MessageType::Hello, body);
  }
  Frame cycle(wire::CycleEntry entry, std::uint8_t slot = 0, int before = 0) {
    entry.vehicle = vehicle_;
    wire::CycleWriter writer{slot, ++counter_};
    for (int i = 0; i < before; ++i) {
      wire::CycleEntry other;
      other.vehicle = static_cast<std::uint8_t>(100 + i);
      writer.add(other, wire::Key{});
    }
    writer.add(entry, session_);
    Frame out(wire::kMaxFrame);
    out.resize(writer.finish(out));
    return out;
  }
  Frame poll() { return cycle({0, wire::CommandMode::Poll, 0, 0, 0, nextEvent}); }
  Frame drive(std::int16_t mmPerSecond, std::uint16_t bearing, std::uint8_t expiry = 25) {
    return cycle({0, wire::CommandMode::Drive, mmPerSecond, bearing, expiry, nextEvent});
  }
  Frame stop() { return cycle({0, wire::CommandMode::Stop, 0, 0, 0, nextEvent}); }
  Frame clear() { return cycle({0, wire::CommandMode::Clear, 0, 0, 0, nextEvent}); }
  Frame request(wire::MessageType type, std::uint8_t parameter, std::int32_t number = 0) {
    std::array<std::uint8_t, 5> body;
    const std::size_t n = encode(wire::Request{type, parameter, number}, body);
    return sealed(session_, ++counter_, type, wire::Bytes{body}.first(n));
  }

  Frame pair(const wire::Key& fresh) {
    newKey = fresh;
    ++counter_;
    std::array<std::uint8_t, 24> body;
    encode(wire::makePair(key_, fresh, {{nonce_, identity->boot, identity->hello}, counter_}), body);
    return sealed(session_, counter_, wire::MessageType::Pair, body);
  }
  /// Calls with this key from now on.
  void useKey(const wire::Key& key) { key_ = key; }

  /// What the vehicle sent. Frames that are not authentic are counted and otherwise ignored.
  void take(wire::Bytes bytes) {
    decoder_.feed(bytes, [&](const wire::Frame& frame) { takeFrame(frame); });
  }

  std::optional<wire::Identity> identity;
  std::optional<wire::Hail> hail;
  std::optional<wire::Report> report;
  std::optional<wire::Value> value;
  std::optional<wire::Paired> paired;
  bool pairedUnderNewKey = false;
  std::optional<wire::Key> newKey;  ///< of the last pair()
  int reports = 0;
  int unauthentic = 0;
  std::uint8_t nextEvent = 0;
  std::uint32_t counter() const { return counter_; }
  void skipCounterTo(std::uint32_t c) { counter_ = c; }

private:
  Frame sealed(const wire::Key& key, std::uint32_t counter, wire::MessageType type, wire::Bytes body) {
    Frame out(wire::kMaxFrame);
    out.resize(wire::sealFrame(key, counter, {vehicle_, 0, static_cast<std::uint8_t>(type), 0}, body, out));
    return out;
  }
  void takeFrame(const wire::Frame& frame) {
    const auto parts = wire::splitMac(frame.payload);
    if (!parts || frame.header.from != vehicle_) return;
    const auto type = static_cast<wire::MessageType>(frame.header.type);
    if (type == wire::MessageType::Paired) return takePaired(frame, *parts);
    const bool longTerm = type == wire::MessageType::Identity || type == wire::MessageType::Hail;
    const bool good =
        longTerm ? wire::sameMac(wire::macOf(key_, frame.header.counter, frame.header, parts->body), parts->mac)
                 : guard_.accept(session_, frame.header, parts->body, parts->mac) == wire::Refusal::None;
    if (!good) {
      ++unauthentic;
      return;
    }
    if (type == wire::MessageType::Hail) hail = wire::decodeHail(parts->body);
    if (type == wire::MessageType::Value) value = wire::decodeValue(parts->body);
    if (type == wire::MessageType::Identity) takeIdentity(parts->body);
    if (type == wire::MessageType::Report) {
      report = wire::decodeReport(parts->body);
      ++reports;
    }
  }
  void takePaired(const wire::Frame& frame, const wire::Sealed& parts) {
    const auto under = [&](const wire::Key& key) {
      return wire::sameMac(wire::macOf(key, 0, frame.header, parts.body), parts.mac);
    };
    pairedUnderNewKey = newKey && under(*newKey);
    if (pairedUnderNewKey || under(key_)) paired = wire::decodePaired(parts.body);
  }
  void takeIdentity(wire::Bytes body) {
    const auto got = wire::decodeIdentity(body);
    if (!got || got->hostNonce != nonce_) return;
    identity = got;
    session_ = wire::deriveSessionKey(key_, {nonce_, got->boot, got->hello});
    guard_ = wire::ReplayGuard{};
  }

  std::uint8_t vehicle_;
  wire::Key key_;
  wire::Key session_{};
  wire::ReplayGuard guard_;
  wire::FrameDecoder decoder_;
  std::uint32_t nonce_ = 0;
  std::uint32_t counter_ = 0;
};

}  // namespace tessera::firmware::test
