// What was seen of one vehicle's locating so far: the reads' innovations, and the errors where the truth is known. No
// drawing here.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "locate/innovation.h"
#include "supervisor/locating_view.h"
#include "supervisor/snapshot.h"
#include "ui/locating/truth_source.h"

namespace tessera::ui {

class LocatingRecord {
public:
  static constexpr int kWindow = 25;              ///< reads over which NIS is averaged
  static constexpr std::size_t kReads = 1000;     ///< kept
  static constexpr std::size_t kErrors = 3000;    ///< kept
  static constexpr double kHonest = 2.0;          ///< NIS and NEES of a place on average
  static constexpr double kSingleBound = 5.9915;  ///< of one read's NIS, 95 %

  struct Read {
    Seconds at;
    double nis = 0.0;
    double mean = 0.0;  ///< of the last kWindow reads, this one included
  };
  /// The newest running mean, and what it may be.
  struct Verdict {
    enum class Is { Open, Honest, TooSure, TooCautious };
    Is is = Is::Open;
    int count = 0;
    double mean = 0.0;
    locate::MeanBounds bounds;
  };
  struct Errors {
    std::size_t count = 0;
    Metres now;
    Metres mean;
    Metres p95;
    double nees = 0.0;  ///< mean, of the place
  };

  /// Each snapshot once, in their order; takes what it tells of its watched vehicle. Another vehicle, or time that runs
  /// backwards, begins anew. False: nothing new.
  bool take(const supervisor::Snapshot& snapshot);
  /// The error follows at once, or with the next snapshot.
  void take(const TruthSample& truth);
  void clear();

  [[nodiscard]] const std::deque<Read>& reads() const { return reads_; }
  [[nodiscard]] Verdict verdict() const;
  [[nodiscard]] Errors errors() const;
  [[nodiscard]] Seconds now() const { return now_; }

private:
  struct Belief {
    Seconds at;
    Pose pose;
    std::array<double, 9> covariance;
  };
  struct Miss {
    double away = 0.0;
    double nees = 0.0;
  };
  void judge();

  std::optional<VehicleId> vehicle_;
  Seconds now_;
  std::deque<Read> reads_;
  std::optional<Seconds> lastRead_;
  std::deque<Belief> beliefs_;  ///< of the last seconds
  std::deque<TruthSample> pending_;
  std::deque<Miss> misses_;
};

}  // namespace tessera::ui
