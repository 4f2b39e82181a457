#include "link/air_timing.h"

#include <algorithm>
#include <cmath>

#include "wire/airtime.h"
#include "wire/messages.h"

namespace tessera::link {
namespace {

constexpr double kSlowestFactor = 3.2;    // of the modules seen in the field
constexpr double kLargestFactor = 4.0;    // nothing measured is believed beyond
constexpr double kModulePause = 0.005;    // the receiving module holds AUX low before its UART begins
constexpr double kPacketEndBytes = 3.0;   // of silence, after which a short packet leaves
constexpr double kSmallestSpread = 0.15;  // of the factor
constexpr double kSlotGuard = 0.006;      // vehicles answer within a few ms of their slot's beginning
constexpr double kGain = 1.0 / 8;         // mean and deviation as in RFC 6298
constexpr double kDeviationGain = 1.0 / 4;
constexpr double kMissGain = 1.0 / 8;
constexpr double kManyMisses = 0.3;
constexpr unsigned kMaxSlotUnits = 255;

}  // namespace

AirTiming::AirTiming(double airRate, int baud)
    : airRate_{airRate}, byteTime_{10.0 / std::max(baud, 300)}, factor_{kSlowestFactor} {}

Seconds AirTiming::latency(std::size_t bytes, double factor) const {
  const double uart = (2.0 * static_cast<double>(bytes) + kPacketEndBytes) * byteTime_;
  return Seconds{uart + kModulePause + factor * wire::loRaAirtime(bytes, airRate_)};
}

double AirTiming::upperFactor() const {
  if (!any_) return kSlowestFactor * std::min(stretch_, kLargestFactor / kSlowestFactor);
  const double spread = std::max(kSmallestSpread, 4.0 * deviation_);
  return std::min((factor_ + spread) * stretch_, kLargestFactor);
}

unsigned AirTiming::slotUnits() const {
  const double length = upperFactor() * wire::loRaAirtime(wire::kMaxFrame, airRate_) + kSlotGuard;
  return static_cast<unsigned>(std::ceil(length * 1000.0 / wire::kSlotUnitMs));
}

std::size_t AirTiming::maxEntries() const { return slotUnits() > kMaxSlotUnits ? 1 : wire::kMaxCycleEntries; }

void AirTiming::measured(std::size_t sentBytes, std::size_t receivedBytes, Seconds roundTrip) {
  const double fixed = (latency(sentBytes, 0.0) + latency(receivedBytes, 0.0)).value();
  const double air = wire::loRaAirtime(sentBytes, airRate_) + wire::loRaAirtime(receivedBytes, airRate_);
  const double seen = std::clamp((roundTrip.value() - fixed) / air, 0.0, kLargestFactor);
  if (!any_) {
    factor_ = seen;
    deviation_ = 0.25 * kSmallestSpread;
    any_ = true;
    return;
  }
  deviation_ += kDeviationGain * (std::abs(seen - factor_) - deviation_);
  factor_ += kGain * (seen - factor_);
}

void AirTiming::missed() {
  missShare_ += kMissGain * (1.0 - missShare_);
  if (missShare_ < kManyMisses) return;
  stretch_ = std::min(1.2 * stretch_, kLargestFactor);
  missShare_ = 0.0;
}

void AirTiming::answered() {
  missShare_ -= kMissGain * missShare_;
  stretch_ = std::max(1.0, 0.995 * stretch_);
}

}  // namespace tessera::link
