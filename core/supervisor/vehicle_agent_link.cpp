// What the channel tells of a vehicle, and the sentences that come of it.
#include <algorithm>

#include "floor/bearing.h"
#include "supervisor/vehicle_agent.h"

namespace tessera::supervisor {
namespace {

constexpr Radians kAsExpected{0.15};  // looking elsewhere, it did something else

// What is heard on the air is one matter, whether the host or the vehicle noticed it.
EventKind kindOf(std::uint16_t fault) {
  if (fault == wire::kFaultForged) return EventKind::ForgedFrames;
  if (fault == wire::kFaultReplayed) return EventKind::ReplayedFrames;
  return EventKind::Fault;
}

using Change = Episode::Change;

constexpr std::size_t kLargestEvent = 12;     // bytes; what has no room for it may have left something out
constexpr std::size_t kMaxUnknownTags = 100;  // told by name; more are a floor that was not registered

Sentence hardwareText(std::uint8_t hardware) {
  switch (hardware) {
    case 1:
      return "LM3S6965";
    case 2:
      return phrase("Core", "host build");
    default:
      return phrase("Core", "other hardware");
  }
}

}  // namespace

void VehicleAgent::inTouch(EventLog& log) {
  if (silent_.notSeen(Seconds{0}) == Change::Ends)
    log.tell(Severity::Info, EventKind::Silent, id(), phrase("Core", "%1 answers again.").with(name_), true);
  if (wrongKey_.active()) {
    wrongKey_.forget();
    log.tell(Severity::Info, EventKind::WrongKey, id(), phrase("Core", "%1 now bears the site's key.").with(name_),
             true);
  }
  if (wrongVersion_.active()) {
    wrongVersion_.forget();
    log.tell(Severity::Info, EventKind::WrongVersion, id(),
             phrase("Core", "%1 now speaks our version of the protocol.").with(name_), true);
  }
  contact_ = Contact::Connected;
}

void VehicleAgent::take(const link::Identified& e, EventLog& log) {
  const wire::Identity& who = e.identity;
  firmware_ = phrase("Core", "%1.%2.%3 on %4")
                  .with(who.firmwareMajor, who.firmwareMinor, who.firmwarePatch, hardwareText(who.hardware));
  const bool known = contact_ == Contact::Silent || restart_.active();
  sent_.reset();  // nothing is known to be in force in a new session
  if (e.restarted) {
    // Its odometer and its commands are gone; its place is what it was.
    odometer_.restart();
    history_.clear();
    learner_.restart();
    if (restart_.active()) {
      restart_.forget();
      log.tell(Severity::Info, EventKind::Restarted, id(),
               phrase("Core", "%1 is in touch again after its restart.").with(name_), true);
    } else {
      log.tell(Severity::Warning, EventKind::Restarted, id(),
               phrase("Core", "%1 has restarted while it was out of touch.").with(name_));
      log.tell(Severity::Info, EventKind::Restarted, id(),
               phrase("Core", "%1 is in touch again after its restart.").with(name_), true);
    }
  }
  restart_.forget();
  inTouch(log);
  if (!known)
    log.tell(Severity::Info, EventKind::Identified, id(),
             phrase("Core", "%1 is identified: firmware %2, %3 tag readers, %4 rangers.")
                 .with(name_, firmware_, who.readers, who.rangers));
  if (who.readers != setup_.readers.size())
    log.tell(
        Severity::Warning, EventKind::Identified, id(),
        phrase("Core", "%1 has %2 tag readers, the site says %3.").with(name_, who.readers, setup_.readers.size()));
}

void VehicleAgent::take(const link::WrongKey&, EventLog& log) {
  contact_ = Contact::Refused;
  if (wrongKey_.seen(Seconds{0}) == Change::Begins)
    log.tell(
        Severity::Error, EventKind::WrongKey, id(),
        phrase("Core",
               "%1 answers with another key than the site's; it is not commanded. Commission it, or mend the site.")
            .with(name_));
}

void VehicleAgent::take(const link::PairingEnded& e, bool inSession, EventLog& log) {
  if (e.how == link::PairingEnd::NewKey && !inSession) contact_ = Contact::Calling;
  const Severity severity = e.how == link::PairingEnd::NewKey   ? Severity::Info
                            : e.how == link::PairingEnd::Failed ? Severity::Error
                                                                : Severity::Warning;
  log.tellPairing(severity, id(), pairingSentence(name_, e.how), e.how);
}

void VehicleAgent::take(const link::WrongVersion& e, EventLog& log) {
  contact_ = Contact::Refused;
  if (wrongVersion_.seen(Seconds{0}) == Change::Begins)
    log.tell(Severity::Error, EventKind::WrongVersion, id(),
             phrase("Core", "%1 speaks version %2 of the protocol, this program speaks %3; it is not commanded.")
                 .with(name_, e.protocol, wire::kProtocolVersion));
}

void VehicleAgent::take(const link::Restarted& e, EventLog& log) {
  contact_ = Contact::Calling;
  history_.clear();
  if (restart_.seen(Seconds{0}) == Change::Begins)
    log.tell(Severity::Warning, EventKind::Restarted, id(),
             phrase("Core", "%1 has restarted (%2); it is called again.").with(name_, causeText(e.cause)));
}

void VehicleAgent::take(const link::Silent& e, Seconds now, EventLog& log) {
  contact_ = Contact::Silent;
  if (silent_.seen(Seconds{0}) == Change::Begins)
    log.tell(
        Severity::Error, EventKind::Silent, id(),
        phrase("Core",
               "%1 has not answered for %2 s; it stops by itself when its command runs out, and is called until it "
               "answers.")
            .with(name_, decimal((now - e.since).value(), 1)));
}

void VehicleAgent::take(const link::BackAgain&, EventLog& log) { inTouch(log); }

void VehicleAgent::take(const link::CommandSent& e) {
  const Seconds expiry{e.entry.expiry * wire::kExpiryUnitMs / 1000.0};
  if (e.entry.mode == wire::CommandMode::Poll) return;
  Sent sent;
  sent.view.mode = e.entry.mode;
  sent.view.sentAt = e.sentAt;
  sent.counter = e.counter;
  sent.effectiveAt = e.effectiveAt;
  if (e.entry.mode == wire::CommandMode::Drive && wished_) {
    sent.view.speed = wished_->speed;
    sent.view.heading = wished_->heading;
    sent.view.expiry = expiry;
    history_.drive(*wished_, e.effectiveAt, expiry, e.counter);
  } else {
    history_.stand(e.effectiveAt, e.counter);
    // A Stop is repeated for as long as it holds; once taken it stays taken.
    if (sent_ && sent_->view.mode == e.entry.mode) sent.view.status = sent_->view.status;
  }
  sent_ = sent;
}

void VehicleAgent::take(const link::CommandAcknowledged& e) {
  history_.taken(e.counter);
  if (!sent_ || sent_->counter != e.counter) return;
  sent_->view.status = CommandStatus::Acknowledged;
  if (sent_->view.mode == wire::CommandMode::Clear) clearing_ = false;
}

void VehicleAgent::take(const link::Disbelieved& e, Seconds now, EventLog& log) {
  switch (e.why) {
    case link::Disbelief::Forged:
      if (forged_.seen(now) == Change::Begins)
        log.tell(
            Severity::Warning, EventKind::ForgedFrames, id(),
            phrase("Core",
                   "A frame in the name of %1 does not bear its key and was dropped: forged, changed on the way, or "
                   "of an earlier meeting.")
                .with(name_));
      return;
    case link::Disbelief::Replayed:
      if (replayed_.seen(now) == Change::Begins)
        log.tell(Severity::Warning, EventKind::ReplayedFrames, id(),
                 phrase("Core", "A frame of %1 came a second time and was dropped: somebody repeats old frames.")
                     .with(name_));
      return;
    default:
      if (strange_.seen(now) == Change::Begins)
        log.tell(Severity::Warning, EventKind::StrangeFrames, id(),
                 phrase("Core", "A frame in the name of %1 makes no sense and was dropped.").with(name_));
  }
}

void VehicleAgent::take(const link::Reported& e, EventLog& log) {
  const drive::VehicleState expected = expectedAt(e.sampledAt).state;
  last_ = e;
  motion_ = locate::Motion{e.sampledAt, odometer_.add(e.report.travel), MetresPerSecond{e.report.speed / 1000.0},
                           reportedHeading()};
  foresee();
  locator_->add(*motion_);
  const locate::Estimate moved = locator_->at(locator_->lastMotion());
  takeTags(e, log);
  tellSilence(e);
  estimate_ = locator_->at(locator_->lastMotion());
  // A report does not tell how fast it turns. Where it looks as was expected, it turns as was expected.
  const bool asExpected = abs(turnBetween(expected.pose.heading, estimate_.pose.heading)) < kAsExpected;
  turnRate_ = asExpected && !isHeld() ? expected.turnRate : estimate_.turnRate;
  if (magnetic_) learner_.take(moved, estimate_, *magnetic_);
  watchPlace(log);
  watchState(e.receivedAt, log);
}

void VehicleAgent::takeTags(const link::Reported& e, EventLog& log) {
  if (e.tagEventsLost > 0)
    log.tell(Severity::Warning, EventKind::TagEventsLost, id(),
             phrase("Core", "%1 tag reads of %2 were lost.").with(e.tagEventsLost, name_));
  for (const link::TimedTagEvent& tag : e.tags) {
    if (tag.older) continue;  // an instant that is not known would mislead more than the read tells
    // The readers' silence until then first: it says where the edge of the disc was, and all that came before is told.
    if (e.tagEventsLost == 0 && toldUntil_ != Seconds{}) tellSilence(tag.at, false);
    if (tag.event.kind == wire::EventKind::Left) {
      locator_->add(locate::TagLeft{tag.event.reader, tag.at});
      continue;
    }
    const auto uid = floor::TagUid::fromBytes(wire::Bytes{tag.event.uid}.first(wire::uidLength(tag.event.kind)));
    if (!uid) continue;
    ++reads_;
    if (recentReads_.size() == kRecentReads) recentReads_.erase(recentReads_.begin());
    recentReads_.push_back({*uid, tag.event.reader, tag.at, map_->find(*uid)});
    if (watched_) noteInnovation(recentReads_.back());
    locator_->add(locate::TagRead{tag.event.reader, *uid, tag.at});
    const bool news = !map_->find(*uid) && unknownTags_.size() < kMaxUnknownTags && unknownTags_.insert(*uid).second;
    if (news)
      log.tell(Severity::Warning, EventKind::UnknownTag, id(),
               phrase("Core", "%1 read the tag %2, which the site does not have.").with(name_, uid->text()));
  }
}

// Events are numbered and come in their order, so what a report does not tell has not happened.
void VehicleAgent::tellSilence(const link::Reported& e) {
  std::size_t used = 0;
  for (std::size_t i = 0; i < e.report.eventCount; ++i) used += wire::wireSize(e.report.events[i]);
  const bool all = used + kLargestEvent <= wire::Report::kEventRoom;
  const Seconds until = all ? e.sampledAt : (e.tags.empty() ? toldUntil_ : e.tags.back().at);
  tellSilence(until, e.tagEventsLost > 0 || toldUntil_ == Seconds{});
}

void VehicleAgent::tellSilence(Seconds until, bool gap) {
  if (until <= toldUntil_) return;
  locator_->told(gap ? until : toldUntil_, until);
  toldUntil_ = until;
}

void VehicleAgent::watchPlace(EventLog& log) {
  if (estimate_.located && !everLocated_) {
    everLocated_ = true;
    log.tell(Severity::Info, EventKind::Located, id(), phrase("Core", "%1 is located.").with(name_));
  } else if (everLocated_ && lost_.update(!estimate_.located, Seconds{0}) != Change::None) {
    if (lost_.active())
      log.tell(Severity::Error, EventKind::Lost, id(), phrase("Core", "%1 has lost its place and stands.").with(name_));
    else
      log.tell(Severity::Info, EventKind::Lost, id(), phrase("Core", "%1 has found its place again.").with(name_),
               true);
  }
  if (!estimate_.located) doubted_.forget();  // that says more
  const Change doubt = doubted_.update(estimate_.doubted, estimate_.at);
  if (doubt == Change::Begins)
    log.tell(Severity::Warning, EventKind::Doubted, id(),
             phrase("Core", "%1 read a tag that lies elsewhere: it goes on slowly until others tell where it is.")
                 .with(name_));
  else if (doubt == Change::Ends)
    log.tell(Severity::Info, EventKind::Doubted, id(), phrase("Core", "%1 is sure of its place again.").with(name_),
             true);
}

void VehicleAgent::watchState(Seconds now, EventLog& log) {
  const wire::Report& report = last_->report;
  // A vehicle that a dead ranger holds reports the same state: whether something stands there, it does not know.
  const bool stands = report.state == wire::VehicleState::Obstacle;
  const bool blind = (report.faults & wire::kFaultRanger) != 0;
  const Change obstacle = stands && blind ? Change::None : obstacle_.update(stands, now);
  if (obstacle == Change::Begins)
    log.tell(Severity::Warning, EventKind::Obstacle, id(),
             report.range >= wire::kFarthestRange
                 ? phrase("Core", "%1 stands before an obstacle.").with(name_)
                 : phrase("Core", "%1 stands before an obstacle, %2 cm away.").with(name_, report.range));
  if (obstacle == Change::Ends)
    log.tell(Severity::Info, EventKind::Obstacle, id(), phrase("Core", "The obstacle before %1 is gone.").with(name_),
             true);

  const Change expired = expired_.update(task_ == Task::Running && report.state == wire::VehicleState::Expired, now);
  if (expired == Change::Begins)
    log.tell(Severity::Warning, EventKind::Expired, id(),
             phrase("Core", "%1 stopped by itself, because no command reached it in time.").with(name_));
  if (expired == Change::Ends)
    log.tell(Severity::Info, EventKind::Expired, id(), phrase("Core", "%1 takes commands again.").with(name_), true);

  for (std::size_t i = 0; i < faults_.size(); ++i) {
    const FaultText& text = faultTexts()[i];
    const Change change = faults_[i].update((report.faults & text.bit) != 0, now);
    if (change == Change::Begins)
      log.tell(text.error ? Severity::Error : Severity::Warning, kindOf(text.bit), id(), text.begins.with(name_));
    if (change == Change::Ends) log.tell(Severity::Info, kindOf(text.bit), id(), text.ends.with(name_), true);
  }
}

}  // namespace tessera::supervisor
