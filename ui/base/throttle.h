// Lets through at once what comes seldom and holds back what comes in floods: people read ten pictures a second, the
// supervision makes fifty.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <functional>
#include <utility>

namespace tessera::ui {

class Throttle {
public:
  /// `work` runs at most once in `intervalMs`, always once more after the last request.
  Throttle(int intervalMs, std::function<void()> work) : interval_{intervalMs}, work_{std::move(work)} {
    timer_.setSingleShot(true);
    timer_.setTimerType(Qt::PreciseTimer);
    QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] { run(); });
  }

  void request() {
    if (timer_.isActive()) return;
    const qint64 rest = since_.isValid() ? interval_ - since_.elapsed() : 0;
    if (rest <= 0) {
      run();
    } else {
      timer_.start(static_cast<int>(rest));
    }
  }

private:
  void run() {
    since_.start();
    work_();
  }

  int interval_;
  std::function<void()> work_;
  QElapsedTimer since_;
  QTimer timer_;
};

}  // namespace tessera::ui
