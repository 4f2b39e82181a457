// What the checks' sentences and lists of faults have in common.
#pragma once

#include <string>

#include "sitecheck/fault.h"

namespace tessera::sitecheck {

/// "1.25", with a point in every language.
[[nodiscard]] std::string figure(double value, int decimals);
[[nodiscard]] inline std::string inMetres(Metres m) { return figure(m.value(), 2); }
[[nodiscard]] inline std::string inCentimetres(Metres m) { return figure(100 * m.value(), 1); }
/// "(1.20, 0.60)"
[[nodiscard]] std::string placeText(Point p);

/// Gathers the faults of one kind: the first so many one by one, the rest as a count with the floor that they take up.
class FaultList {
public:
  FaultList(Faults& into, FaultKind kind, Severity severity, std::size_t most)
      : into_{into}, kind_{kind}, severity_{severity}, most_{most} {}
  FaultList(const FaultList&) = delete;
  FaultList& operator=(const FaultList&) = delete;

  /// make() fills the fault's sentence, objects and fix; it is not called for faults beyond the limit.
  template <class Make>
  void add(const std::optional<Box>& place, const Make& make) {
    if (count_++ < most_) {
      Fault fault = make();
      fault.kind = kind_;
      fault.severity = severity_;
      fault.place = place;
      into_.push_back(std::move(fault));
    } else if (place) {
      rest_ = rest_ ? boxAround(*rest_, *place) : *place;
    }
  }
  /// Tells of those that were only counted. To be called last.
  void close();

private:
  Faults& into_;
  FaultKind kind_;
  Severity severity_;
  std::size_t most_;
  std::size_t count_ = 0;
  std::optional<Box> rest_;
};

}  // namespace tessera::sitecheck
