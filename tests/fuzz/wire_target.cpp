#include <algorithm>
#include <array>

#include "fuzz/targets.h"
#include "wire/messages.h"
#include "wire/pairing.h"

namespace tessera::fuzz {
namespace {

using namespace wire;

template <class Message>
void comesBack(const std::optional<Message>& m, Bytes body) {
  if (!m) return;
  std::array<std::uint8_t, kMaxPayload> out{};
  const std::size_t n = encode(*m, out);
  require(std::ranges::equal(Bytes{out}.first(n), body), "what was decoded is encoded to the same bytes");
}

void decodeAll(Bytes body) {
  comesBack(decodeHello(body), body);
  comesBack(decodeIdentity(body), body);
  comesBack(decodeHail(body), body);
  comesBack(decodeReport(body), body);
  comesBack(decodeValue(body), body);
  comesBack(decodePair(body), body);
  comesBack(decodePaired(body), body);
  if (const auto pair = decodePair(body)) require(!openPair(*pair, {}, {}), "no key without its proof");
  for (auto type : {MessageType::Get, MessageType::Set, MessageType::Do}) comesBack(decodeRequest(type, body), body);
}

void command(const Frame& frame, ReplayGuard& guard) {
  for (unsigned vehicle = 0; vehicle < 256; ++vehicle) {
    const auto part = findEntry(frame.payload, static_cast<std::uint8_t>(vehicle));
    if (!part) continue;
    require(part->entry.vehicle == vehicle, "an entry is its vehicle's");
    require(part->index < kMaxCycleEntries, "no more entries than fit");
    require(part->entry.mode <= CommandMode::Clear, "a known mode");
    const std::uint32_t before = guard.last();
    const Refusal refusal = guard.accept({}, frame.header, part->authenticated, part->mac);
    require(refusal == Refusal::None ? guard.last() > before : guard.last() == before, "counters only grow");
  }
}

}  // namespace

void wire(std::span<const std::uint8_t> input) {
  decodeAll(input);
  FrameDecoder decoder;
  ReplayGuard guard;
  std::size_t inFrames = 0;
  const auto take = [&](const Frame& frame) {
    require(frame.payload.size() <= kMaxPayload, "no payload longer than a packet");
    inFrames += frame.payload.size() + kFrameOverhead;
    std::array<std::uint8_t, kMaxFrame> again{};
    require(encodeFrame(frame.header, frame.payload, again) == frame.payload.size() + kFrameOverhead,
            "frames re-encode");
    decodeAll(frame.payload);
    if (const auto sealed = splitMac(frame.payload)) decodeAll(sealed->body);
    command(frame, guard);
  };
  // The input's bytes say how it is cut, as a serial port cuts where it likes.
  for (std::size_t at = 0; at < input.size();) {
    const std::size_t n = std::min<std::size_t>(input.size() - at, 1U + (input[at] & 63U));
    decoder.feed(input.subspan(at, n), take);
    at += n;
    if ((n & 7U) == 7U) decoder.flush(take);
  }
  decoder.flush(take);
  require(!decoder.pending(), "nothing is left after a silence");
  require(decoder.counters().skipped + inFrames == input.size(), "every byte is a frame's or skipped");
}

std::vector<Input> wireSeeds() {
  std::vector<Input> seeds;
  std::uint32_t counter = 0;
  const auto add = [&](MessageType type, const auto& message) {
    std::array<std::uint8_t, kMaxPayload> body{};
    const std::size_t n = encode(message, body);
    Input frame(kMaxFrame);
    const FrameHeader header{1, 0, static_cast<std::uint8_t>(type), 0};
    frame.resize(sealFrame({}, ++counter, header, Bytes{body}.first(n), frame));
    seeds.push_back(frame);
  };
  add(MessageType::Hello, Hello{1, 2});
  add(MessageType::Identity, Identity{});
  add(MessageType::Hail, Hail{});
  add(MessageType::Get, Request{MessageType::Get, 2, 0});
  add(MessageType::Set, Request{MessageType::Set, 2, 100'000});
  add(MessageType::Do, Request{MessageType::Do, 1, 0});
  add(MessageType::Value, Value{});
  add(MessageType::Pair, makePair({}, Key{1, 2, 3}, {{1, 2, 3}, 4}));
  add(MessageType::Paired, Paired{1, 2, Outcome::Busy});
  Report report;
  report.eventCount = 3;
  for (std::size_t i = 0; i < 3; ++i) report.events[i].kind = static_cast<EventKind>(i);
  add(MessageType::Report, report);
  CycleWriter cycle{9, ++counter};
  for (std::uint8_t v = 1; v <= 4; ++v) cycle.add({.vehicle = v, .mode = CommandMode::Drive, .speed = 100}, {});
  Input frame(kMaxFrame);
  frame.resize(cycle.finish(frame));
  seeds.push_back(frame);
  Input all;
  for (const Input& seed : seeds) all.insert(all.end(), seed.begin(), seed.end());
  seeds.push_back(all);
  return seeds;
}

}  // namespace tessera::fuzz
