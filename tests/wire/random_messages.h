// Messages of every shape that the wire allows, from a random source.
#pragma once

#include <limits>
#include <random>

#include "wire/messages.h"

namespace tessera::wire {

using Random = std::mt19937_64;

/// Any value of an unsigned or signed integer, its ends more often than chance would give.
template <class T>
[[nodiscard]] T anyOf(Random& random) {
  switch (random() % 8) {
    case 0:
      return std::numeric_limits<T>::min();
    case 1:
      return std::numeric_limits<T>::max();
    default:
      return static_cast<T>(random());
  }
}

[[nodiscard]] Key randomKey(Random& random);
[[nodiscard]] Hello randomHello(Random& random);
[[nodiscard]] Identity randomIdentity(Random& random);
[[nodiscard]] Hail randomHail(Random& random);
/// With as many events as chance gives and the frame holds.
[[nodiscard]] Report randomReport(Random& random);
[[nodiscard]] Request randomRequest(Random& random);
[[nodiscard]] Value randomValue(Random& random);
[[nodiscard]] CycleEntry randomEntry(Random& random);

}  // namespace tessera::wire
