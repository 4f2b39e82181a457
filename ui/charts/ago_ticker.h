// Ticks of a time axis that counts back from now: round distances from the right end, in seconds or minutes.
#pragma once

#include <qcustomplot.h>

#include <array>

namespace tessera::ui {

class AgoTicker : public QCPAxisTicker {
public:
  /// `now` in the axis' own seconds.
  void setNow(double now, bool minutes) {
    minutes_ = minutes;
    setTickOrigin(now);
  }
  [[nodiscard]] bool minutes() const { return minutes_; }

protected:
  double getTickStep(const QCPRange& range) override {
    static constexpr std::array kSteps{0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 30.0, 60.0, 120.0, 300.0};
    for (const double step : kSteps)
      if (range.size() / step <= 8.0) return step;
    return 600.0;
  }
  int getSubTickCount(double /*tickStep*/) override { return 0; }
  QString getTickLabel(double tick, const QLocale& locale, QChar /*formatChar*/, int /*precision*/) override {
    const double ago = (tick - tickOrigin()) / (minutes_ ? 60.0 : 1.0);
    return locale.toString(std::abs(ago) < 1e-9 ? 0.0 : ago, 'g', 3);
  }

private:
  bool minutes_ = false;
};

}  // namespace tessera::ui
