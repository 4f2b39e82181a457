#include "firmware/vehicle/radio.h"

#include <algorithm>

namespace tessera::firmware {
namespace {

constexpr std::uint32_t kConfigureBaud = 9600;
constexpr std::uint32_t kBauds[] = {1200, 2400, 4800, 9600, 19200, 38400, 57600, 115200};
constexpr std::uint8_t kOption = 0x44;  // transparent, push-pull, 250 ms wake-up, FEC, 20 dBm
constexpr std::uint8_t kSave = 0xC0;
constexpr std::uint8_t kRead = 0xC1;
constexpr int kTries = 3;
constexpr Micros kQuiet = 3ms;  // after AUX has risen the module needs 2 ms
constexpr Micros kAuxPatience = 500ms;
constexpr Micros kAnswerPatience = 150ms;
constexpr Micros kWritePatience = 50ms;  // AUX may fall a little after the last byte

}  // namespace

std::array<std::uint8_t, 6> radioRegisters(const Settings& settings) {
  const auto baud = static_cast<unsigned>(settings.get(wire::Parameter::RadioBaud));
  const auto air = static_cast<unsigned>(settings.get(wire::Parameter::RadioAirRate));
  const auto channel = static_cast<std::uint8_t>(settings.get(wire::Parameter::RadioChannel));
  return {kSave, 0, 0, static_cast<std::uint8_t>(baud << 3 | air), channel, kOption};
}

void Radio::start(const Settings& settings, Micros now) {
  wanted_ = radioRegisters(settings);
  baud_ = kBauds[settings.get(wire::Parameter::RadioBaud)];
  silence_ = std::max<Micros>(20ms, Micros{50'000'000 / baud_});
  faulty_ = false;
  begin(now);
}

void Radio::begin(Micros now) {
  tries_ = 0;
  board_.setBaud(Uart::Radio, kConfigureBaud);
  board_.setRadioMode(RadioMode::Configure);
  go(State::Enter, now);
}

void Radio::go(State next, Micros now) {
  state_ = next;
  entered_ = now;
  busyUntil_ = now + kQuiet;
}

// AUX high without a break for `quiet`. A module that never becomes ready is given up after half a second.
bool Radio::idleFor(Micros quiet, Micros now) {
  if (!board_.radioReady()) busyUntil_ = now + quiet;
  return now >= busyUntil_ || now - entered_ > kAuxPatience;
}

void Radio::configure(Micros now) {
  switch (state_) {
    case State::Enter:
      if (idleFor(kQuiet, now)) ask(now);
      break;
    case State::Answer:
      takeAnswer(now);
      break;
    case State::Write:
      if (now - entered_ > kWritePatience && idleFor(kQuiet, now)) ask(now);
      break;
    case State::Leave:
      board_.setRadioMode(RadioMode::Normal);
      board_.setBaud(Uart::Radio, baud_);
      go(State::Settle, now);
      break;
    case State::Settle:
      if (!idleFor(kQuiet, now)) break;
      lastFrame_ = now;
      go(State::Talking, now);
      break;
    case State::Off:
    case State::Talking:
      break;
  }
}

void Radio::ask(Micros now) {
  std::array<std::uint8_t, 32> rubbish{};
  for (int i = 0; i < 20 && board_.read(Uart::Radio, rubbish) == rubbish.size(); ++i) {
  }
  answered_ = 0;
  const std::array<std::uint8_t, 3> request{kRead, kRead, kRead};
  board_.write(Uart::Radio, request);
  go(State::Answer, now);
}

// The module answers with C0 and its registers. Another answer than the wanted one, or none, is a failed try.
void Radio::takeAnswer(Micros now) {
  answered_ += board_.read(Uart::Radio, std::span{answer_}.subspan(answered_));
  if (answered_ < answer_.size() && now - entered_ < kAnswerPatience) return;
  const bool whole = answered_ == answer_.size();
  if (whole && answer_ == wanted_) {
    faulty_ = false;
    go(State::Leave, now);
  } else if (++tries_ > kTries) {
    faulty_ = true;
    go(State::Leave, now);
  } else if (whole) {
    board_.write(Uart::Radio, wanted_);
    go(State::Write, now);
  } else {
    ask(now);
  }
}

bool Radio::canSend() {
  return state_ == State::Talking && outDone_ == outSize_ && board_.sent(Uart::Radio) && board_.radioReady();
}

bool Radio::send(wire::Bytes frame) {
  if (frame.empty() || frame.size() > out_.size() || !canSend()) return false;
  std::copy(frame.begin(), frame.end(), out_.begin());
  outSize_ = frame.size();
  outDone_ = 0;
  pushOut();
  return true;
}

bool Radio::sent() { return outDone_ == outSize_ && board_.sent(Uart::Radio); }

// A gap of three byte times would split the frame into two packets: hand over as much as the board takes.
void Radio::pushOut() {
  if (outDone_ < outSize_)
    outDone_ += board_.write(Uart::Radio, std::span{out_}.subspan(outDone_, outSize_ - outDone_));
}

}  // namespace tessera::firmware
