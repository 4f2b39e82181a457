// What is asked of single vehicles besides driving: parameters, actions, another key.
#include <algorithm>

#include "link/channel.h"

namespace tessera::link {
namespace {

constexpr Seconds kWriteTime{0.060};  // a vehicle may write its EEPROM before it answers a request
constexpr Seconds kKeyTime{0.250};    // and reads a key back, several times over when it has to
constexpr std::size_t kMaxRequests = 32;
constexpr unsigned kRequestTries = 3;

}  // namespace

bool Channel::request(VehicleId vehicle, const wire::Request& request) {
  const auto index = indexOf(vehicle);
  if (!index || requests_.size() >= kMaxRequests) return false;
  requests_.push_back({*index, request, 0, std::nullopt});
  return true;
}

bool Channel::pair(VehicleId vehicle, const wire::Key& fresh) {
  const auto index = indexOf(vehicle);
  const auto same = [&](const Pending& p) { return p.newKey && p.peer == *index; };
  if (!index || !peers_[*index].connected() || requests_.size() >= kMaxRequests ||
      std::any_of(requests_.begin(), requests_.end(), same))
    return false;
  requests_.push_back({*index, {}, 0, fresh});
  return true;
}

std::size_t Channel::sendRequest(Seconds now, std::span<std::uint8_t> out) {
  Pending& pending = requests_.front();
  ++pending.tries;
  ++counter_;
  Session& session = peers_[pending.peer].session;
  const std::size_t size =
      pending.newKey ? session.pair(*pending.newKey, counter_, out) : session.request(pending.request, counter_, out);
  departed(Turn::Kind::Request, std::span{&pending.peer, 1}, size, Seconds{}, now);
  flight_->answers[0].deadline += pending.newKey ? kKeyTime : kWriteTime;
  return size;
}

// The answer to a request has stayed away.
void Channel::closeRequest() {
  if (requests_.empty()) return;
  const Pending& pending = requests_.front();
  const unsigned limit = !pending.newKey && pending.request.type == wire::MessageType::Do ? 1 : kRequestTries;
  if (pending.tries < limit) return;
  unanswered(pending);
  requests_.pop_front();
}

void Channel::dropHopelessRequests() {
  while (!requests_.empty() && !peers_[requests_.front().peer].connected() &&
         !(flight_ && flight_->kind == Turn::Kind::Request)) {
    unanswered(requests_.front());
    requests_.pop_front();
  }
}

void Channel::unanswered(const Pending& pending) {
  Session& session = peers_[pending.peer].session;
  if (!pending.newKey) {
    events_.emplace_back(Answered{session.vehicle(), pending.request, std::nullopt});
    return;
  }
  session.pairingGivenUp();
  // Never sent: nothing is unknown about it.
  const PairingEnd how = pending.tries > 0 ? PairingEnd::Unknown : PairingEnd::OldKey;
  events_.emplace_back(PairingEnded{session.vehicle(), how});
}

// Whatever frame has told it: an answer, a call's answer, or a report that could not be if the key were another.
void Channel::hearPairing(std::size_t index) {
  Peer& peer = peers_[index];
  const auto end = peer.session.takePairingEnd();
  if (!end) return;
  std::erase_if(requests_, [&](const Pending& p) { return p.newKey && p.peer == index && p.tries > 0; });
  events_.emplace_back(PairingEnded{peer.session.vehicle(), *end});
  if (*end != PairingEnd::NewKey || peer.session.open()) return;
  peer.silent = false;
  peer.callsMade = 0;
  peer.calls.reset(lastByte_);
}

}  // namespace tessera::link
