// How often a vehicle's readers try, learned from how long they held their tags: a visit lasts a whole number of
// attempts. Nobody has to be asked for it, and a row whose readers are slowed down by their bus tells so itself.
#pragma once

#include <array>
#include <cstddef>

namespace tessera::locate {

class PollClock {
public:
  static constexpr double kUsual = 0.10;  ///< s; taken until the visits say otherwise

  /// A tag was read first and last this long apart.
  void visit(double lasted);
  [[nodiscard]] double period() const { return period_; }

private:
  static constexpr std::size_t kCandidates = 72;  ///< 5 % apart, from 20 ms on

  std::array<double, kCandidates> score_{};
  int visits_ = 0;
  double period_ = kUsual;
};

}  // namespace tessera::locate
