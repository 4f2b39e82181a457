#include "ui/commission/pairing.h"

#include <chrono>

#include "ui/base/wording.h"
#include "ui/commission/vehicle_draft.h"
#include "wire/pairing.h"
#include "wire/parameters.h"

namespace tessera::ui {
namespace {

// Time to switch a vehicle on and for it to be called; the world of the demo starts anew within it.
constexpr auto kPairingPatience = std::chrono::seconds{90};

}  // namespace

Pairing::Pairing(Commissioning& work, QObject* parent) : QObject{parent}, work_{work}, series_{work.link()} {
  patience_.setSingleShot(true);
  patience_.setInterval(kPairingPatience);
  connect(&patience_, &QTimer::timeout, this, [this] {
    fail(phase_ == Phase::Calling
             ? tr("No vehicle fresh from the factory has answered. Is it switched on, flashed and in reach? If it was "
                  "set up before, it has an address and a key already: type its key below.")
             : tr("The vehicle no longer answers. Switch it off and on again and press “Pair now” once more."));
  });
  connect(&work_, &Commissioning::seen, this, &Pairing::look);
  connect(&work_.link(), &FleetLink::eventsArrived, this, &Pairing::hear);
  connect(&series_, &AskSeries::answered, this, [this](std::size_t, const supervisor::AskAnswer& answer) {
    const bool set = answer.request.type == wire::MessageType::Set;
    if (set && answer.value->outcome != wire::Outcome::Done)
      fail(tr("The vehicle refuses the address %1. Choose another one.").arg(work_.draft().id.value));
  });
  connect(&series_, &AskSeries::finished, this, &Pairing::finish);
  connect(&series_, &AskSeries::failed, this, &Pairing::fail);
}

void Pairing::await(Phase phase, const QString& sentence) {
  phase_ = phase;
  patience_.start();
  Q_EMIT progressed(sentence);
}

void Pairing::start() {
  fresh_ = VehicleDraft::randomKey();
  if (work_.silence().isEmpty()) return askForKey();
  await(Phase::Calling, tr("Calling a vehicle that is fresh from the factory…"));
  if (const auto entered = work_.enterAs(kFreshAddress, wire::kFactoryKey); !entered)
    fail(text(entered.error().sentence));
}

void Pairing::look() {
  if (phase_ != Phase::Calling && phase_ != Phase::CallingAgain) return;
  const supervisor::VehicleView* vehicle = work_.view();
  if (vehicle == nullptr) return;
  if (vehicle->contact == supervisor::Contact::Connected) {
    if (phase_ == Phase::Calling)
      askForKey();
    else
      askForAddress();
  } else if (vehicle->contact == supervisor::Contact::Refused && phase_ == Phase::Calling) {
    fail(tr("A vehicle answers at the factory's address, but with another key. Type its key below."));
  }
}

void Pairing::askForKey() {
  await(Phase::Keying, tr("Giving the vehicle its new key…"));
  patience_.stop();  // the supervision tells how it ends, and whether it is in doubt
  unsure_ = false;
  const auto picture = work_.link().latest();
  asked_ = picture ? picture->time : Seconds{};
  if (!work_.link().post(supervisor::Pair{work_.address(), fresh_}))
    fail(tr("Not connected. Connect to the vehicles and try again."));
}

void Pairing::hear(const std::vector<supervisor::Event>& events) {
  for (const supervisor::Event& event : events) {
    if (phase_ != Phase::Keying || event.vehicle != work_.address() || event.time <= asked_) continue;
    if (event.kind == supervisor::EventKind::OrderRefused) {
      fail(text(event.sentence));
    } else if (event.kind == supervisor::EventKind::Paired && event.pairing == link::PairingEnd::NewKey) {
      takeKey();
    } else if (event.kind == supervisor::EventKind::Paired && event.pairing == link::PairingEnd::Unknown) {
      unsure_ = true;  // both keys are tried until the vehicle proves one
      Q_EMIT progressed(text(event.sentence));
    } else if (event.kind == supervisor::EventKind::Paired) {
      unsure_ = event.pairing == link::PairingEnd::Failed;
      fail(text(event.sentence));
    }
  }
}

// The site first: whatever comes next, the key is not lost.
void Pairing::takeKey() {
  floor::VehicleSetup draft = work_.draft();
  draft.key = fresh_;
  work_.setDraft(draft);
  const VehicleId address = work_.address();
  await(Phase::CallingAgain, tr("It has its key. Waiting for it under the new key…"));
  if (const auto entered = work_.enterAs(address, fresh_); !entered) return fail(text(entered.error().sentence));
  work_.setPaired();
  if (address == work_.draft().id) finish();
}

void Pairing::askForAddress() {
  await(Phase::Addressing, tr("Giving the vehicle its address %1…").arg(work_.draft().id.value));
  series_.start(work_.address(),
                {{wire::MessageType::Set, static_cast<std::uint8_t>(wire::Parameter::Address), work_.draft().id.value},
                 {wire::MessageType::Do, static_cast<std::uint8_t>(wire::Action::Restart), 0}});
}

void Pairing::finish() {
  if (phase_ == Phase::Idle) return;
  phase_ = Phase::Idle;
  patience_.stop();
  if (const auto entered = work_.enter(); !entered) {
    Q_EMIT failed(text(entered.error().sentence));
    return;
  }
  Q_EMIT done();
}

void Pairing::fail(const QString& sentence) {
  if (phase_ == Phase::Idle) return;
  const QString doubt = this->doubt();
  cancel();
  Q_EMIT failed(doubt.isEmpty() ? sentence : sentence + QLatin1Char('\n') + doubt);
}

QString Pairing::doubt() const {
  if (phase_ != Phase::Keying || !unsure_) return {};
  return tr("It may have taken this key; note it down and try it if the old one is refused: %1")
      .arg(VehicleDraft::keyText(fresh_));
}

void Pairing::cancel() {
  const bool untouched = phase_ == Phase::Calling || phase_ == Phase::Keying;
  phase_ = Phase::Idle;
  patience_.stop();
  series_.stop();
  // A vehicle that has taken its key but not its address stays in the site as it is.
  if (untouched) (void)work_.enter();
}

}  // namespace tessera::ui
