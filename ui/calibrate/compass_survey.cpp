#include "ui/calibrate/compass_survey.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

#include "ui/base/wording.h"

namespace tessera::ui {
namespace {

using calibrate::CompassCorrection;
using wire::MessageType;
using wire::Outcome;
using wire::Parameter;

constexpr int kAgainMs = 100;
constexpr qint64 kTurnShowsMs = 3000;  // a turn that was begun shows in the reports by then, or is over already
constexpr double kNanotesla = 1e-3;    // in µT
constexpr double kTenThousandth = 1e-4;
constexpr double kRightWithin = 1.0;  // degrees of heading

CompassCorrection correctionOf(const CompassSurvey::Values& v) {
  return {v[0] * kNanotesla,     v[1] * kNanotesla,     v[2] * kTenThousandth,
          v[3] * kTenThousandth, v[4] * kTenThousandth, v[5] * kTenThousandth};
}

CompassSurvey::Values valuesOf(const CompassCorrection& c) {
  const auto count = [](double value, double unit) { return static_cast<std::int32_t>(std::lround(value / unit)); };
  return {count(c.offsetX, kNanotesla), count(c.offsetY, kNanotesla), count(c.xx, kTenThousandth),
          count(c.xy, kTenThousandth),  count(c.yx, kTenThousandth),  count(c.yy, kTenThousandth)};
}

// The turn begins with the direction in the middle of the row and goes on upwards: asked for in this order, each is
// there soon after it is asked for.
std::size_t directionAt(std::size_t step) { return (step + wire::kCompassSamples / 2) % wire::kCompassSamples; }

}  // namespace

CompassSurvey::CompassSurvey(FleetLink& fleet) : fleet_{fleet}, series_{fleet} {
  again_.setSingleShot(true);
  again_.setInterval(kAgainMs);
  connect(&again_, &QTimer::timeout, this, &CompassSurvey::askForSample);
  connect(&series_, &AskSeries::answered, this, &CompassSurvey::hear);
  connect(&series_, &AskSeries::failed, this, [this](const QString& sentence) {
    if (turns()) fleet_.post(supervisor::Stop{*vehicle_});
    end(Notice::Tone::Error, sentence);
  });
  connect(&fleet_, &FleetLink::snapshotChanged, this, &CompassSurvey::look);
}

std::vector<wire::Request> CompassSurvey::requests(MessageType type, const Values& values) const {
  std::vector<wire::Request> all;
  for (std::size_t i = 0; i < values.size(); ++i)
    all.push_back({type, static_cast<std::uint8_t>(static_cast<std::size_t>(Parameter::CompassOffsetX) + i),
                   type == MessageType::Set ? values[i] : 0});
  return all;
}

const supervisor::VehicleView* CompassSurvey::view() const {
  const auto snapshot = fleet_.latest();
  return snapshot && vehicle_ ? snapshot->find(*vehicle_) : nullptr;
}

std::optional<CompassCorrection> CompassSurvey::present() const {
  return present_ ? std::optional{correctionOf(*present_)} : std::nullopt;
}

bool CompassSurvey::mayWrite() const {
  return !isBusy() && fit_ && !fit_->objection() && present_ && valuesOf(fit_->correction) != *present_;
}

bool CompassSurvey::mayRestore() const {
  if (isBusy() || !vehicle_ || !present_) return false;
  const auto old = before_.find(*vehicle_);
  return old != before_.end() && old->second != *present_;
}

void CompassSurvey::start(VehicleId vehicle) {
  vehicle_ = vehicle;
  samples_ = {};
  points_.clear();
  fit_.reset();
  present_.reset();
  right_.reset();
  seenTurning_ = false;
  tooOld_ = false;
  phase_ = Phase::Reading;
  tone_ = Notice::Tone::Info;
  message_ = tr("Reading what the vehicle corrects its compass by…");
  Q_EMIT changed();
  series_.start(vehicle, requests(MessageType::Get, {}));
}

void CompassSurvey::stop() {
  if (!measures()) return;
  if (turns()) fleet_.post(supervisor::Stop{*vehicle_});
  end(Notice::Tone::Info, tr("Stopped. Nothing was changed in the vehicle."));
}

void CompassSurvey::end(Notice::Tone tone, const QString& message) {
  again_.stop();
  series_.stop();
  phase_ = Phase::Idle;
  tone_ = tone;
  message_ = message;
  Q_EMIT changed();
}

void CompassSurvey::hear(std::size_t index, const supervisor::AskAnswer& answer) {
  const wire::Value& value = *answer.value;
  const bool last = index + 1 == Values{}.size();
  switch (phase_) {
    case Phase::Idle:
      return;
    case Phase::Reading:
    case Phase::Verifying:
      if (value.outcome != Outcome::Done)
        return end(Notice::Tone::Error, tr("The vehicle has no values to correct its compass by."));
      if (!present_) present_.emplace();
      (*present_)[index] = value.value;
      if (!last) return;
      return phase_ == Phase::Reading ? askForTurn() : checkWritten();
    case Phase::Writing:
      if (value.outcome != Outcome::Done || value.value != wanted_[index])
        return end(Notice::Tone::Error, tr("The vehicle did not take the values: read them again by turning anew."));
      if (last) {
        phase_ = Phase::Verifying;
        series_.start(*vehicle_, requests(MessageType::Get, {}));
      }
      return;
    case Phase::Starting:
      switch (value.outcome) {
        case Outcome::Started:
          phase_ = Phase::Turning;
          sinceStart_.start();
          Q_EMIT changed();
          return askForSample();
        case Outcome::Unknown:
          tooOld_ = true;
          return end(Notice::Tone::Error,
                     tr("The vehicle's program is too old to tell what its compass measures. It can only calibrate by "
                        "itself, without a chart: the wizard's page of the compass has a button for it (Vehicle › "
                        "Change the chosen vehicle)."));
        case Outcome::Busy:
          return end(Notice::Tone::Error, tr("The vehicle drives or turns already. Stop it, then try again."));
        default:
          return end(
              Notice::Tone::Error,
              tr("The vehicle refuses: it has a fault, or its compass does not answer. Clear it, then try again."));
      }
    case Phase::Turning:
    case Phase::Fetching:
      return hearSample(answer);
  }
}

void CompassSurvey::askForTurn() {
  phase_ = Phase::Starting;
  message_ = tr("The vehicle turns on the spot…");
  Q_EMIT changed();
  series_.start(*vehicle_, {{MessageType::Do, static_cast<std::uint8_t>(wire::Action::SurveyCompass), 0}});
}

void CompassSurvey::askForSample() {
  for (std::size_t step = 0; step < samples_.size(); ++step) {
    const std::size_t direction = directionAt(step);
    if (samples_[direction]) continue;
    const std::size_t number = static_cast<std::size_t>(Parameter::CompassSample) + direction;
    return series_.start(*vehicle_, {{MessageType::Get, static_cast<std::uint8_t>(number), 0}});
  }
}

void CompassSurvey::hearSample(const supervisor::AskAnswer& answer) {
  const bool told = answer.value->outcome == Outcome::Done && answer.value->value != wire::kNoCompassSample;
  if (told) {
    const wire::CompassCounts c = wire::unpackCompass(answer.value->value);
    const calibrate::FieldPoint point{c.x * wire::kCompassCountNanotesla * kNanotesla,
                                      c.y * wire::kCompassCountNanotesla * kNanotesla};
    samples_[answer.request.parameter - static_cast<std::size_t>(Parameter::CompassSample)] = point;
    points_.push_back(point);
    Q_EMIT changed();
  }
  if (phase_ == Phase::Fetching) {
    if (!series_.isRunning()) judge();
  } else if (told) {
    askForSample();
  } else {
    again_.start();
  }
}

void CompassSurvey::look() {
  const supervisor::VehicleView* vehicle = view();
  if (phase_ != Phase::Turning) return;
  if (vehicle == nullptr || vehicle->contact != supervisor::Contact::Connected)
    return end(Notice::Tone::Error, tr("The vehicle has fallen silent. It stops turning by itself."));
  const bool turning = vehicle->state == wire::VehicleState::Calibrating;
  seenTurning_ = seenTurning_ || turning;
  if (!turning && (seenTurning_ || sinceStart_.elapsed() > kTurnShowsMs)) fetchRest();
}

// What is missing is asked for once more, in one go: the vehicle has what it will ever have.
void CompassSurvey::fetchRest() {
  again_.stop();
  phase_ = Phase::Fetching;
  message_ = tr("Fetching the rest of what was measured…");
  std::vector<wire::Request> rest;
  for (std::size_t step = 0; step < samples_.size(); ++step)
    if (!samples_[directionAt(step)])
      rest.push_back({MessageType::Get,
                      static_cast<std::uint8_t>(static_cast<std::size_t>(Parameter::CompassSample) + directionAt(step)),
                      0});
  Q_EMIT changed();
  if (rest.empty()) return judge();
  series_.start(*vehicle_, std::move(rest));
}

void CompassSurvey::judge() {
  fit_ = calibrate::fitCompass(points_);
  if (!fit_)
    return end(Notice::Tone::Error,
               tr("Too little was measured: the vehicle hardly turned, or its compass is silent."));
  if (const auto objection = fit_->objection())
    return end(Notice::Tone::Error, text(*objection) + QLatin1Char(' ') + tr("The vehicle keeps its values."));
  const double worst = degrees(errorOfPresent());
  const QString off = QLocale{}.toString(worst, 'f', 1);
  if (worst < kRightWithin) {
    right_ = true;
    end(Notice::Tone::Good, tr("The values in the vehicle are right: they turn the heading by at most %1°.").arg(off));
  } else {
    end(Notice::Tone::Warning,
        tr("The values in the vehicle turn the heading by up to %1°. Write those found into it.").arg(off));
  }
}

Radians CompassSurvey::errorOfPresent() const {
  return Radians{calibrate::largestTurn(correctionOf(*present_), fit_->correction, points_)};
}

void CompassSurvey::write() {
  if (!mayWrite()) return;
  before_.try_emplace(*vehicle_, *present_);
  put(valuesOf(fit_->correction));
}

void CompassSurvey::restore() {
  if (mayRestore()) put(before_.at(*vehicle_));
}

void CompassSurvey::put(const Values& values) {
  wanted_ = values;
  right_ = false;
  phase_ = Phase::Writing;
  tone_ = Notice::Tone::Info;
  message_ = tr("Writing into the vehicle…");
  Q_EMIT changed();
  series_.start(*vehicle_, requests(MessageType::Set, values));
}

void CompassSurvey::checkWritten() {
  const supervisor::VehicleView* vehicle = view();
  if (*present_ != wanted_)
    return end(Notice::Tone::Error, tr("The vehicle has other values than were written. Write them again."));
  if (vehicle != nullptr && (vehicle->faults & wire::kFaultEeprom) != 0)
    return end(Notice::Tone::Error,
               tr("The values are in force, but the vehicle could not keep them: they are lost when "
                  "it is switched off."));
  // The old values may be those that the last turn found wrong.
  right_ = fit_ && !fit_->objection() && degrees(errorOfPresent()) < kRightWithin;
  const bool old = wanted_ == before_.at(*vehicle_);
  end(Notice::Tone::Good, old ? tr("The vehicle has its old values back.")
                              : tr("Written and read back. Turn once more to see what they do."));
}

}  // namespace tessera::ui
