#include "firmware/vehicle/tag_log.h"

#include <algorithm>

namespace tessera::firmware {
namespace {

wire::EventKind kindOf(std::uint8_t length) {
  if (length == 4) return wire::EventKind::Uid4;
  return length == 7 ? wire::EventKind::Uid7 : wire::EventKind::Uid10;
}

}  // namespace

void TagLog::take(const Reading& reading, Micros now) {
  if (reading.reader >= heads_.size()) return;
  Head& head = heads_[reading.reader];
  if (head.heard && head.counter == reading.counter) return;
  head.heard = true;
  head.counter = reading.counter;
  if (reading.length == 0) {
    if (head.length > 0 && ++head.misses >= kMisses) leave(reading.reader);
    return;
  }
  if (head.length > 0 && (head.length != reading.length || head.uid != reading.uid)) leave(reading.reader);
  const bool came = head.length == 0;
  head.length = reading.length;
  head.uid = reading.uid;
  head.lastGood = now;
  head.misses = 0;
  if (came) enter(reading.reader, now);
}

void TagLog::enter(std::uint8_t reader, Micros time) {
  const Head& head = heads_[reader];
  add({reader, kindOf(head.length), head.uid, time});
}

void TagLog::leave(std::uint8_t reader) {
  Head& head = heads_[reader];
  add({reader, wire::EventKind::Left, {}, head.lastGood});
  head.length = 0;
  head.misses = 0;
}

void TagLog::add(const Event& event) {
  if (count_ == kCapacity) {
    oldest_ = (oldest_ + 1) % kCapacity;
    --count_;
    ++first_;
    if (reported_ > 0) --reported_;
    lost_ = true;
  }
  ring_[(oldest_ + count_) % kCapacity] = event;
  ++count_;
}

void TagLog::acknowledge(std::uint8_t next) {
  const auto done = static_cast<std::uint8_t>(next - first_);
  if (done > reported_) return;
  oldest_ = (oldest_ + done) % kCapacity;
  count_ -= done;
  reported_ -= done;
  first_ = next;
}

void TagLog::beginSession(Micros now) {
  reported_ = 0;
  for (std::uint8_t reader = 0; reader < std::uint8_t{kMaxReaders}; ++reader)
    if (heads_[reader].length > 0) enter(reader, std::min(now, heads_[reader].lastGood));
}

void TagLog::fill(wire::Report& report, Micros now) {
  report.firstEvent = first_;
  report.eventCount = 0;
  std::size_t room = wire::Report::kEventRoom;
  for (std::size_t i = 0; i < count_ && i < report.events.size(); ++i) {
    const Event& from = ring_[(oldest_ + i) % kCapacity];
    wire::TagEvent to;
    to.reader = from.reader;
    to.kind = from.kind;
    to.uid = from.uid;
    to.age = static_cast<std::uint8_t>(std::clamp<std::int64_t>((now - from.time) / 10ms, 0, 255));
    if (wire::wireSize(to) > room) break;
    room -= wire::wireSize(to);
    report.events[i] = to;
    ++report.eventCount;
  }
  reported_ = std::max<std::size_t>(reported_, report.eventCount);
  lost_ = false;
}

}  // namespace tessera::firmware
