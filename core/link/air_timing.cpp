#include "link/air_timing.h"

#include <algorithm>
#include <cmath>

#include "wire/airtime.h"
#include "wire/messages.h"

namespace tessera::link {
namespace {

constexpr double kSlowestFactor = 3.2;    // of the modules seen in the field
constexpr double kModulePause = 0.005;    // the receiving module holds AUX low before its UART begins
constexpr double kPacketEndBytes = 3.0;   // of silence, after which a short packet leaves
constexpr double kSmallestSpread = 0.15;  // of the factor
constexpr double kSlotGuard = 0.006;      // vehicles answer within a few ms of their slot's beginning
constexpr double kDeviations = 4.0;       // of room, as in RFC 6298
constexpr double kMissGain = 1.0 / 8;
constexpr double kManyMisses = 0.3;
constexpr unsigned kMaxSlotUnits = 255;

}  // namespace

AirTiming::AirTiming(double airRate, int baud) : airRate_{airRate}, byteTime_{10.0 / std::max(baud, 300)} {}

Seconds AirTiming::latency(std::size_t bytes, double factor) const {
  const double uart = (2.0 * static_cast<double>(bytes) + kPacketEndBytes) * byteTime_;
  return Seconds{uart + kModulePause + factor * wire::loRaAirtime(bytes, airRate_)};
}

double AirTiming::factor() const { return trips_.any() ? trips_.factor() : kSlowestFactor; }

Seconds AirTiming::delay() const { return trips_.any() ? 0.5 * trips_.extra() : Seconds{0.5 * called_}; }

double AirTiming::upperFactor() const {
  const double usual = trips_.any() ? trips_.factorAtMost() + kSmallestSpread : kSlowestFactor;
  return std::min(usual * stretch_, std::max(usual, TripModel::kLargestFactor));
}

// What trips spread, in seconds, beyond the room that the factor gives anyway.
double AirTiming::unsteady() const {
  if (!trips_.any()) return 0.0;
  return std::max(0.0, kDeviations * trips_.deviation().value() - kSmallestSpread * trips_.usualAir().value());
}

Seconds AirTiming::oneWayAtMost(std::size_t bytes) const {
  const double late = trips_.any() ? trips_.late().value() : 0.0;
  const Seconds measured = latency(bytes, upperFactor()) + delay() + Seconds{0.5 * (unsteady() + late)};
  if (called_ <= 0.0) return measured;
  return std::max(measured, latency(bytes, kSlowestFactor) + Seconds{0.5 * called_});
}

// Half of a trip's variance is one way's. An error of the factor shows as far as the frame differs from half a trip.
Seconds AirTiming::oneWayDoubt(std::size_t bytes) const {
  if (!trips_.any()) return Seconds{};
  const double spread = trips_.standardDeviation().value() / std::sqrt(2.0);
  const double split = trips_.factorDoubt() * (wire::loRaAirtime(bytes, airRate_) - 0.5 * trips_.usualAir().value());
  return Seconds{std::hypot(spread, split)};
}

// A delay that all answers have alike does not bring them nearer to each other.
unsigned AirTiming::slotUnits() const {
  const double length = upperFactor() * wire::loRaAirtime(wire::kMaxFrame, airRate_) + unsteady() + kSlotGuard;
  return static_cast<unsigned>(std::ceil(length * 1000.0 / wire::kSlotUnitMs));
}

std::size_t AirTiming::maxEntries() const { return slotUnits() > kMaxSlotUnits ? 1 : wire::kMaxCycleEntries; }

void AirTiming::measured(std::size_t sentBytes, std::size_t receivedBytes, Seconds roundTrip) {
  const Seconds fixed = latency(sentBytes, 0.0) + latency(receivedBytes, 0.0);
  const double air = wire::loRaAirtime(sentBytes, airRate_) + wire::loRaAirtime(receivedBytes, airRate_);
  trips_.measured(Seconds{air}, roundTrip - fixed);
  if (trips_.any()) called_ = 0.0;
}

void AirTiming::called(std::size_t sentBytes, std::size_t receivedBytes, Seconds roundTrip) {
  const Seconds slowest = latency(sentBytes, kSlowestFactor) + latency(receivedBytes, kSlowestFactor);
  const Seconds beyond = roundTrip - slowest;
  if (beyond <= TripModel::kLongestExtra) called_ = std::max(0.0, beyond.value());
}

void AirTiming::missed() {
  missShare_ += kMissGain * (1.0 - missShare_);
  if (missShare_ < kManyMisses) return;
  stretch_ = std::min(1.2 * stretch_, TripModel::kLargestFactor);
  missShare_ = 0.0;
}

void AirTiming::answered() {
  missShare_ -= kMissGain * missShare_;
  stretch_ = std::max(1.0, 0.995 * stretch_);
}

}  // namespace tessera::link
