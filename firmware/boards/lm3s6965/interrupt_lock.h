// Keeps interrupts out for the few instructions in which main loop and interrupt handlers share something.
#pragma once

#include <cstdint>

namespace tessera::firmware::lm3s6965 {

/// Nests: interrupts come back only if they were allowed before. On a host, where the drivers are tested, it is empty.
class InterruptLock {
public:
#ifdef __arm__
  InterruptLock() { asm volatile("mrs %0, primask\n\tcpsid i" : "=r"(before_)::"memory"); }
  ~InterruptLock() { asm volatile("msr primask, %0" ::"r"(before_) : "memory"); }
#else
  InterruptLock() {}
  ~InterruptLock() {}
#endif
  InterruptLock(const InterruptLock&) = delete;
  InterruptLock& operator=(const InterruptLock&) = delete;

private:
  std::uint32_t before_ = 0;
};

}  // namespace tessera::firmware::lm3s6965
