// Waits for a condition while Qt's events run.
#pragma once

#include <QCoreApplication>
#include <functional>

#include "host/supervisor_thread.h"

namespace tessera::test {

/// False: it did not come true in time.
inline bool until(const std::function<bool()>& condition, double seconds = 10) {
  const Seconds end = host::steadyNow() + Seconds{seconds};
  while (!condition() && host::steadyNow() < end) QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
  return condition();
}

}  // namespace tessera::test
