// Reader offsets and wheel scale from drives over the paper floor, simulated apart from the program's own world.
#include "calibrate/reader_calibration.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

#include "calibrate/block_arrow.h"
#include "calibrate/figure.h"
#include "locate/paper_floor.h"
#include "locate/synthetic_drive.h"

namespace tessera::test {
namespace {

using calibrate::calibrateReaders;
using calibrate::DriveRecord;

/// Takes the place of a locator and writes down what it is told, by an odometer whose wheels are off.
class Recorder final : public locate::Locator {
public:
  Recorder(const floor::SiteMap& map, double scale) : map_{map}, scale_{scale} {}
  void add(const locate::Motion& motion) override {
    locate::Motion shown = motion;
    shown.travel = motion.travel / scale_;
    shown.speed = motion.speed / scale_;
    record.add(shown);
  }
  void add(const locate::TagRead& read) override {
    if (const auto place = map_.find(read.uid)) record.add(calibrate::PlacedRead{read.reader, *place, read.at});
  }
  void add(const locate::TagLeft&) override {}
  [[nodiscard]] locate::Estimate at(Seconds) const override { return {}; }
  [[nodiscard]] Seconds lastMotion() const override {
    return record.motions().empty() ? Seconds{} : record.motions().back().at;
  }
  void reset(std::optional<Pose>) override {}
  void useMap(std::shared_ptr<const floor::SiteMap>) override {}
  [[nodiscard]] const locate::LocatorCounters& counters() const override { return counters_; }
  [[nodiscard]] std::string_view name() const override { return "recorder"; }

  DriveRecord record;

private:
  const floor::SiteMap& map_;
  double scale_;
  locate::LocatorCounters counters_;
};

std::vector<Point> figure(std::uint32_t seed) {
  return calibrate::figure({Metres{0.9}, Metres{0.9}}, Metres{0.65}, Radians{0.7 * seed});
}

floor::VehicleSetup trueVehicle() {
  floor::VehicleSetup vehicle = paperVehicle(2);
  vehicle.readers = {{Metres{0.172}, Metres{0.065}}, {Metres{0.143}, Metres{-0.068}}};
  return vehicle;
}

Metres apart(Offset a, Offset b) { return length(a + -1.0 * b); }

DriveRecord driven(const DriveOptions& options, double scale, const std::vector<Point>& way) {
  const auto map = paperMap();
  Recorder recorder{*map, scale};
  (void)drive(*map, trueVehicle(), way, options, recorder);
  return recorder.record;
}

calibrate::CalibrationOptions atOnce() {
  calibrate::CalibrationOptions options;
  options.readLag = {};  // these readers tell at once
  return options;
}

TEST(ReaderCalibration, recoversWrongOffsetsAndWheelsWithinTheStatedDeviations) {
  const floor::VehicleSetup entered = paperVehicle(2);  // both at 15 cm, 5 cm to either side
  const floor::VehicleSetup truth = trueVehicle();
  double squares = 0.0;
  int count = 0;
  double worst = 0.0;
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    DriveOptions options;
    options.seed = seed;
    options.speedNoise = 0.03;
    const double scale = seed % 2 == 0 ? 1.03 : 0.975;
    const auto result = calibrateReaders(driven(options, scale, figure(seed)), entered, atOnce());
    ASSERT_TRUE(result) << result.error().sentence.english();
    const auto judge = [&](double error, double sigma) {
      EXPECT_LT(std::abs(error), 4.0 * sigma) << "seed " << seed;
      squares += error * error / (sigma * sigma);
      ++count;
    };
    judge(result->wheelScale - scale, result->wheelSigma);
    EXPECT_LT(result->wheelSigma, 0.01);
    for (std::size_t r = 0; r < 2; ++r) {
      const auto& reader = result->readers[r];
      judge((reader.mount.x - truth.readers[r].x).value(), reader.sigmaAhead.value());
      judge((reader.mount.y - truth.readers[r].y).value(), reader.sigmaAside.value());
      EXPECT_LT(reader.sigmaAhead, Metres{0.008});
      EXPECT_LT(reader.sigmaAside, Metres{0.008});
      EXPECT_GT(reader.reads, 15);
      worst = std::max(worst, apart(reader.mount, truth.readers[r]).value());
    }
  }
  std::printf("mean square of errors over deviations %.2f, worst offset error %.1f mm\n", squares / count,
              1000.0 * worst);
  EXPECT_LT(squares / count, 2.0) << "the deviations are honest";
  EXPECT_GT(squares / count, 0.2);
}

TEST(ReaderCalibration, bearsAnOdometerThatTremblesAndReadsThatBelongElsewhere) {
  DriveOptions options;
  options.speedNoise = 0.10;
  DriveRecord record = driven(options, 1.02, figure(1));
  // Tags that lie elsewhere than the map says: one read in twenty is half a metre off.
  DriveRecord wrong;
  for (const auto& motion : record.motions()) wrong.add(motion);
  int n = 0;
  for (calibrate::PlacedRead read : record.reads()) {
    if (++n % 20 == 0) read.tag.x += Metres{0.5};
    wrong.add(read);
  }
  const auto result = calibrateReaders(wrong, paperVehicle(2), atOnce());
  ASSERT_TRUE(result);
  EXPECT_GE(result->outliers, n / 20 - 1);
  EXPECT_LT(result->outliers, n / 8);
  EXPECT_GT(result->unrest, 0.02) << "the drive tells that it trembles";
  for (std::size_t r = 0; r < 2; ++r)
    EXPECT_LT(apart(result->readers[r].mount, trueVehicle().readers[r]), Metres{0.02});
  EXPECT_NEAR(result->wheelScale, 1.02, 4.0 * result->wheelSigma);
}

// Every leg lies along rows of tags, at the same distance from them each time.
TEST(ReaderCalibration, trustsADriveAlongTheRowsLess) {
  std::vector<Point> square;
  for (int round = 0; round < 3; ++round)
    for (const auto& [x, y] : {std::pair{0.3, 0.3}, {1.5, 0.3}, {1.5, 1.5}, {0.3, 1.5}})
      square.push_back({Metres{x}, Metres{y}});
  double squares = 0.0;
  int count = 0;
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    DriveOptions options;
    options.seed = seed;
    options.speedNoise = 0.03;
    const auto result = calibrateReaders(driven(options, 1.0, square), paperVehicle(2), atOnce());
    ASSERT_TRUE(result);
    for (std::size_t r = 0; r < 2; ++r) {
      const auto& reader = result->readers[r];
      const double ahead = (reader.mount.x - trueVehicle().readers[r].x) / reader.sigmaAhead;
      const double aside = (reader.mount.y - trueVehicle().readers[r].y) / reader.sigmaAside;
      squares += ahead * ahead + aside * aside;
      count += 2;
      EXPECT_LT(std::max(std::abs(ahead), std::abs(aside)), 4.0) << "seed " << seed;
      EXPECT_GT(reader.sigmaAside, Metres{0.006});
    }
  }
  std::printf("along the rows: mean square of errors over deviations %.2f\n", squares / count);
}

TEST(ReaderCalibration, saysThatADriveStraightOnTellsNothingOfOffsets) {
  DriveOptions options;
  options.speed = 0.06;
  options.compassNoise = 0.5;
  const DriveRecord record = driven(options, 1.0, {{Metres{0.1}, Metres{0.9}}, {Metres{1.7}, Metres{0.9}}});
  const auto result = calibrateReaders(record, paperVehicle(2), atOnce());
  if (!result) {
    EXPECT_NE(result.error().sentence.english().find("at least 20 are needed"), std::string::npos);
    return;
  }
  for (const auto& reader : result->readers) EXPECT_GT(reader.sigmaAhead, calibrate::kUndetermined);
}

TEST(ReaderCalibration, saysWhatADriveLacksUntilItsOffsetsAreWorthEntering) {
  using calibrate::Lacking;
  const calibrate::CalibratedReader well{{}, Metres{0.006}, Metres{0.007}, 40};
  const calibrate::CalibratedReader poor{{}, Metres{0.006}, Metres{0.009}, 12};
  const calibrate::CalibratedReader dead{{}, Metres{0.05}, Metres{0.05}, 0};
  const auto found = [](std::vector<calibrate::CalibratedReader> readers) {
    calibrate::Calibration result;
    result.readers = std::move(readers);
    return result;
  };
  DriveRecord turned;
  for (int n = 0; n < 20; ++n) {
    EXPECT_EQ(lacking(turned, found({well, well})), Lacking::Turns) << n;
    locate::Motion motion;
    motion.at = Seconds{0.2 * n};
    motion.heading = Radians{0.5 * n};
    turned.add(motion);
  }
  EXPECT_EQ(lacking(turned, found({well, well})), Lacking::Nothing);
  EXPECT_EQ(lacking(turned, found({well, poor})), Lacking::Drive) << "all of them, or the record of the other is lost";
  const calibrate::CalibratedReader vague{{}, Metres{0.015}, Metres{0.021}, 12};
  EXPECT_EQ(lacking(turned, found({well, vague})), Lacking::Drive) << "it will be told of soon";
  EXPECT_EQ(lacking(turned, found({well, dead})), Lacking::Nothing) << "for that one nobody waits";
  EXPECT_EQ(lacking(turned, found({dead, dead})), Lacking::Drive);
}

TEST(ReaderCalibration, asksForMoreReads) {
  const auto result = calibrateReaders({}, paperVehicle(2));
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().sentence.english(), "Only 0 reads can be used; at least 20 are needed.");
}

TEST(Figure, liesOnTheFloorAsNearToTheWishAsItCan) {
  const Box floor{{Metres{1.0}, Metres{0.0}}, {Metres{9.0}, Metres{2.2}}};
  const auto place = calibrate::placeFigure(floor, {Metres{0.0}, Metres{5.0}}, Metres{0.3});
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->radius.value(), 0.8, 1e-12);
  EXPECT_NEAR(place->centre.x.value(), 2.1, 1e-12);
  EXPECT_NEAR(place->centre.y.value(), 1.1, 1e-12);
  for (const Point& p : calibrate::figure(place->centre, place->radius, Radians{0.4})) {
    EXPECT_GT(p.x, Metres{1.29});
    EXPECT_LT(p.y, Metres{1.91});
  }
  EXPECT_FALSE(calibrate::placeFigure({{}, {Metres{8.0}, Metres{1.2}}}, {}, Metres{0.3})) << "too narrow";
}

TEST(BlockArrow, solvesWhatTheWholeMatrixSolves) {
  using calibrate::BlockArrow;
  constexpr int kStates = 4;
  constexpr int kShared = 3;
  constexpr int kAll = 3 * kStates + kShared;
  BlockArrow arrow{kStates, kShared};
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(kAll, kAll);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(kAll);
  std::mt19937 random{1};
  const auto some = [&] { return std::uniform_real_distribution{-1.0, 1.0}(random); };
  for (std::size_t i = 0; i < kStates; ++i) {
    for (int k = 0; k < 3; ++k) {
      const auto slope = BlockArrow::StateSlope::NullaryExpr(2, 3, some).eval();
      const auto next = BlockArrow::StateSlope::NullaryExpr(2, 3, some).eval();
      const BlockArrow::SharedSlope shared = BlockArrow::SharedSlope::NullaryExpr(2, kShared, some);
      const Eigen::Vector2d residual{some(), some()};
      Eigen::MatrixXd row = Eigen::MatrixXd::Zero(2, kAll);
      row.block(0, 3 * static_cast<Eigen::Index>(i), 2, 3) = slope;
      row.rightCols(kShared) = shared;
      if (i + 1 < kStates) {
        row.block(0, 3 * static_cast<Eigen::Index>(i) + 3, 2, 3) = next;
        arrow.addLink(i, slope, next, shared, residual);
      } else {
        arrow.add(i, slope, shared, residual);
      }
      matrix += row.transpose() * row;
      right -= row.transpose() * residual;
    }
  }
  arrow.addPrior(1, 0.3, 2.0);
  matrix(kAll - kShared + 1, kAll - kShared + 1) += 4.0;
  right(kAll - kShared + 1) -= 1.2;
  arrow.solve();
  const Eigen::MatrixXd inverse = matrix.inverse();
  const Eigen::VectorXd whole = inverse * right;
  EXPECT_LT((arrow.shared() - whole.tail(kShared)).norm(), 1e-8);
  EXPECT_LT((arrow.states()[2] - whole.segment<3>(6)).norm(), 1e-8);
  EXPECT_LT((arrow.sharedCovariance() - inverse.bottomRightCorner(kShared, kShared)).norm(), 1e-8);
  EXPECT_NEAR(arrow.logDeterminant(), std::log(matrix.determinant()), 1e-8);
}

}  // namespace
}  // namespace tessera::test
