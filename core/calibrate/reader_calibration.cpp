#include "calibrate/reader_calibration.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "calibrate/block_arrow.h"

namespace tessera::calibrate {
namespace {

constexpr int kMostSteps = 15;
constexpr double kSettled = 1e-6;
constexpr double kHuber = 2.5;    // deviations of a read in the plane from which on it counts less
constexpr double kOutlier = 4.0;  // and from which on it is called one
// What is not known of where in the disc tags are first read is the same for all reads: no number of them makes it
// less.
constexpr double kRimAhead = 0.005;         // m
constexpr double kRimAside = 0.004;         // m
constexpr double kHeadingNoise = 0.03;      // rad, of one reported heading
constexpr double kBiasPerRootMetre = 0.10;  // rad/√m, as the locators have it
constexpr double kBiasPerTurn = 0.02;
constexpr double kLeastBias = 0.005;         // rad
constexpr double kSlipPerRootMetre = 0.008;  // m/√m, across
constexpr double kTurnShare = 0.1;
constexpr double kLeastStep = 0.001;                             // m
constexpr std::array kUnrests{0.006, 0.0125, 0.025, 0.05, 0.1};  // m/√m along, of which the likeliest is taken
constexpr double kSameWay = 0.15;                                // rad
constexpr double kSameRow = 0.015;                               // m
constexpr double kStanding = 0.03;                               // m/s, of a reader
constexpr Seconds kTurnOver{0.15};                               // about a read, over which the turn rate is taken

/// Where in its disc a reader first reads a tag, in vehicle axes.
struct Spot {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
};

Eigen::Matrix2d turnedBy(double angle) {
  Eigen::Matrix2d m;
  m << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return m;
}

// At the front rim, along the reader's own movement: v and, by the turning, w at its lever. Where the movement changes
// just then, the rim is met somewhere else.
Spot spotOf(double radius, double v, double w, Offset mount) {
  const Eigen::Vector2d movement{v - w * mount.y.value(), w * mount.x.value()};
  const double speed = movement.norm();
  Spot spot;
  if (speed < kStanding) {
    spot.covariance = Eigen::Matrix2d::Identity() * 0.25 * radius * radius;
    return spot;
  }
  const locate::InDisc disc = locate::inDisc(Metres{radius}, MetresPerSecond{speed}, {});
  const Eigen::Matrix2d turn = turnedBy(std::atan2(movement.y(), movement.x()));
  spot.mean = turn * Eigen::Vector2d{disc.ahead.value(), 0.0};
  spot.covariance = turn * Eigen::Vector2d{disc.along, disc.across}.asDiagonal() * turn.transpose();
  return spot;
}

/// All that does not change from step to step.
struct Visit {
  int reader = 0;
  Eigen::Vector2d tag;
  double heading = 0.0;
  Spot spot;
  Movement toNext;
};

struct Unknowns {
  std::vector<Eigen::Vector3d> states;  ///< x, y, bias at each read
  Eigen::VectorXd shared;               ///< scale, then x and y of each reader
};

struct Fit {
  Unknowns unknowns;
  Eigen::MatrixXd covariance;
  double cost = 0.0;  ///< twice the negative log of the likelihood, but for what all fits share
  int outliers = 0;
};

// Tags of one row, passed along the row by one reader, are all off to the same side: so many of them tell as much as
// one does of where across its way the reader is.
void shareRows(std::vector<Visit>& visits) {
  std::vector<int> alike(visits.size(), 0);
  for (std::size_t i = 0; i < visits.size(); ++i) {
    const Eigen::Vector2d across{-std::sin(visits[i].heading), std::cos(visits[i].heading)};
    for (const Visit& other : visits) {
      const double turn = std::remainder(visits[i].heading - other.heading, 2.0 * kPi);
      const double off = across.dot(visits[i].tag - other.tag);
      if (other.reader == visits[i].reader && std::abs(turn) < kSameWay && std::abs(off) < kSameRow) ++alike[i];
    }
  }
  for (std::size_t i = 0; i < visits.size(); ++i) visits[i].spot.covariance(1, 1) *= alike[i];
}

std::vector<Visit> visitsOf(const DriveRecord& drive, const floor::VehicleSetup& setup, Seconds lag) {
  std::vector<PlacedRead> reads;
  for (PlacedRead read : drive.reads()) {
    read.at -= lag;
    const bool known = read.reader >= 0 && static_cast<std::size_t>(read.reader) < setup.readers.size();
    if (known && drive.covers(read.at - kTurnOver) && drive.covers(read.at + kTurnOver)) reads.push_back(read);
  }
  std::stable_sort(reads.begin(), reads.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
  std::vector<Visit> visits;
  for (std::size_t i = 0; i < reads.size(); ++i) {
    const PlacedRead& read = reads[i];
    const locate::Motion motion = drive.at(read.at);
    const Radians turn = drive.at(read.at + kTurnOver).heading - drive.at(read.at - kTurnOver).heading;
    const Offset mount = setup.readers[static_cast<std::size_t>(read.reader)];
    Visit visit;
    visit.reader = read.reader;
    visit.tag = {read.tag.x.value(), read.tag.y.value()};
    visit.heading = motion.heading.value();
    visit.spot = spotOf(setup.readerRadius.value(), motion.speed.value(), (turn / (2.0 * kTurnOver)).value(), mount);
    if (i + 1 < reads.size()) visit.toNext = drive.between(read.at, reads[i + 1].at);
    visits.push_back(visit);
  }
  shareRows(visits);
  return visits;
}

class Problem {
public:
  Problem(std::vector<Visit> visits, const floor::VehicleSetup& setup, const CalibrationOptions& options)
      : visits_{std::move(visits)}, options_{options}, size_{1 + 2 * static_cast<Eigen::Index>(setup.readers.size())} {
    before_ = Eigen::VectorXd::Ones(size_);
    for (std::size_t r = 0; r < setup.readers.size(); ++r)
      before_.segment<2>(mountAt(static_cast<int>(r))) << setup.readers[r].x.value(), setup.readers[r].y.value();
  }

  [[nodiscard]] Fit solve(double unrest) const {
    Fit fit;
    fit.unknowns.shared = before_;
    for (const Visit& v : visits_) {
      const Eigen::Vector2d seen = before_.segment<2>(mountAt(v.reader)) + v.spot.mean;
      const Eigen::Vector2d place = v.tag - turnedBy(v.heading) * seen;
      fit.unknowns.states.emplace_back(place.x(), place.y(), 0.0);
    }
    for (int step = 0; step < kMostSteps; ++step) {
      BlockArrow equations{visits_.size(), size_};
      double noise = 0.0;
      fit.outliers = 0;
      addBefore(equations, fit.unknowns);
      for (std::size_t i = 0; i < visits_.size(); ++i) {
        fit.outliers += addRead(equations, fit.unknowns, i) ? 1 : 0;
        if (i + 1 < visits_.size()) noise += addWay(equations, fit.unknowns, i, unrest);
      }
      equations.solve();
      fit.cost = equations.squares() + equations.logDeterminant() + noise;
      fit.covariance = equations.sharedCovariance();
      fit.unknowns.shared += equations.shared();
      for (std::size_t i = 0; i < visits_.size(); ++i) fit.unknowns.states[i] += equations.states()[i];
      if (equations.shared().norm() < kSettled) break;
    }
    return fit;
  }

  [[nodiscard]] static Eigen::Index mountAt(int reader) { return 1 + 2 * static_cast<Eigen::Index>(reader); }

private:
  void addBefore(BlockArrow& equations, const Unknowns& u) const {
    for (Eigen::Index k = 0; k < size_; ++k)
      equations.addPrior(k, u.shared(k) - before_(k), 1.0 / (k == 0 ? options_.scaleSigma : options_.mountSigma));
    BlockArrow::StateSlope slope = BlockArrow::StateSlope::Zero();
    slope(0, 2) = 1.0 / options_.biasSigma;
    equations.add(0, slope, BlockArrow::SharedSlope::Zero(2, size_), {u.states[0](2) / options_.biasSigma, 0.0});
  }

  /// The tag as the reader has it, in vehicle axes. True: it fits nothing.
  bool addRead(BlockArrow& equations, const Unknowns& u, std::size_t i) const {
    const Visit& v = visits_[i];
    const Eigen::Vector2d mount = u.shared.segment<2>(mountAt(v.reader));
    const Eigen::Matrix2d back = turnedBy(u.states[i](2) - v.heading);
    const Eigen::Vector2d seen = back * (v.tag - u.states[i].head<2>());
    const double lever = kHeadingNoise * mount.norm();
    const Eigen::Matrix2d doubt = v.spot.covariance + lever * lever * Eigen::Matrix2d::Identity();
    Eigen::Matrix2d per = doubt.llt().matrixL().solve(Eigen::Matrix2d::Identity());
    Eigen::Vector2d residual = per * (seen - mount - v.spot.mean);
    const double off = residual.norm();
    const double weight = off > kHuber ? std::sqrt(kHuber / off) : 1.0;
    per *= weight;
    residual *= weight;
    BlockArrow::StateSlope slope;
    slope.leftCols<2>() = -per * back;
    slope.col(2) = per * Eigen::Vector2d{-seen.y(), seen.x()};
    BlockArrow::SharedSlope shared = BlockArrow::SharedSlope::Zero(2, size_);
    shared.middleCols<2>(mountAt(v.reader)) = -per;
    equations.add(i, slope, shared, residual);
    return off > kOutlier;
  }

  /// The way to the next read by the odometer, along and across; then what the heading's bias may have changed by.
  /// Returns the log of the noise's determinant.
  double addWay(BlockArrow& equations, const Unknowns& u, std::size_t i, double unrest) const {
    const Movement& m = visits_[i].toNext;
    const double way = m.length.value();
    const double turn = std::abs(m.turn.value());
    const Eigen::Vector2d reported{m.way.x.value(), m.way.y.value()};
    const double bias = 0.5 * (u.states[i](2) + u.states[i + 1](2));
    const Eigen::Vector2d driven = turnedBy(-bias) * reported;
    const double length = driven.norm();
    const double heading = length > kLeastStep ? std::atan2(driven.y(), driven.x()) : 0.0;
    const Eigen::Matrix2d into = turnedBy(-heading);
    const double slip = kSlipPerRootMetre * kSlipPerRootMetre * way + kLeastStep * kLeastStep;
    const double swerve = kTurnShare * turn * way;
    const Eigen::Vector2d variance{unrest * unrest * way + slip, slip + swerve * swerve};
    const Eigen::Vector2d per = variance.cwiseSqrt().cwiseInverse();
    const Eigen::Vector2d residual =
        per.cwiseProduct(into * (u.states[i + 1].head<2>() - u.states[i].head<2>() - u.shared(0) * driven));
    BlockArrow::StateSlope next;
    next.leftCols<2>() = per.asDiagonal() * into;
    // Half of a change of either bias turns the way back by as much.
    next.col(2) = per.cwiseProduct(into * (-0.5 * u.shared(0) * Eigen::Vector2d{driven.y(), -driven.x()}));
    BlockArrow::StateSlope slope = next;
    slope.leftCols<2>() *= -1.0;
    BlockArrow::SharedSlope shared = BlockArrow::SharedSlope::Zero(2, size_);
    shared.col(0) = -per.cwiseProduct(into * driven);
    equations.addLink(i, slope, next, shared, residual);

    const double drift = std::sqrt(kBiasPerRootMetre * kBiasPerRootMetre * way +
                                   kBiasPerTurn * kBiasPerTurn * turn * turn + kLeastBias * kLeastBias);
    BlockArrow::StateSlope biasNext = BlockArrow::StateSlope::Zero();
    biasNext(0, 2) = 1.0 / drift;
    equations.addLink(i, -biasNext, biasNext, BlockArrow::SharedSlope::Zero(2, size_),
                      {(u.states[i + 1](2) - u.states[i](2)) / drift, 0.0});
    return std::log(variance.prod());
  }

  std::vector<Visit> visits_;
  CalibrationOptions options_;
  Eigen::Index size_;
  Eigen::VectorXd before_;
};

}  // namespace

bool isDetermined(const CalibratedReader& reader) {
  return std::max(reader.sigmaAhead, reader.sigmaAside) < kUndetermined;
}

Lacking lacking(const DriveRecord& drive, const Calibration& found) {
  if (drive.turned() < Radians{kFewestHalfTurns * kPi}) return Lacking::Turns;
  // A reader that is as good as dead keeps no other waiting.
  constexpr int kReadsOfADeadOne = 3;
  int known = 0;
  for (const CalibratedReader& reader : found.readers) {
    if (reader.reads < kReadsOfADeadOne) continue;
    if (std::max(reader.sigmaAhead, reader.sigmaAside) >= kWellKnown) return Lacking::Drive;
    ++known;
  }
  return known > 0 ? Lacking::Nothing : Lacking::Drive;
}

Result<Calibration> calibrateReaders(const DriveRecord& drive, const floor::VehicleSetup& setup,
                                     const CalibrationOptions& options) {
  const std::vector<Visit> visits = visitsOf(drive, setup, options.readLag);
  if (visits.size() < kFewestCalibrationReads)
    return failure(phrase("Core", "Only %1 reads can be used; at least %2 are needed.")
                       .with(visits.size(), kFewestCalibrationReads));
  const Problem problem{visits, setup, options};
  Fit best;
  best.cost = std::numeric_limits<double>::infinity();
  Calibration result;
  for (const double unrest : kUnrests) {
    Fit fit = problem.solve(unrest);
    if (!(fit.cost < best.cost)) continue;
    best = std::move(fit);
    result.unrest = unrest;
  }
  if (!best.unknowns.shared.allFinite() || best.unknowns.shared.size() == 0 ||
      !(best.covariance.diagonal().minCoeff() > 0.0))
    return failure(phrase("Core", "Nothing can be told from this drive."));
  result.wheelScale = best.unknowns.shared(0);
  result.wheelSigma = std::sqrt(best.covariance(0, 0));
  result.reads = static_cast<int>(visits.size());
  result.outliers = best.outliers;
  for (std::size_t r = 0; r < setup.readers.size(); ++r) {
    const Eigen::Index at = Problem::mountAt(static_cast<int>(r));
    CalibratedReader reader;
    reader.mount = {Metres{best.unknowns.shared(at)}, Metres{best.unknowns.shared(at + 1)}};
    reader.sigmaAhead = Metres{std::hypot(std::sqrt(best.covariance(at, at)), kRimAhead)};
    reader.sigmaAside = Metres{std::hypot(std::sqrt(best.covariance(at + 1, at + 1)), kRimAside)};
    reader.reads = static_cast<int>(
        std::count_if(visits.begin(), visits.end(), [&](const Visit& v) { return v.reader == static_cast<int>(r); }));
    result.readers.push_back(reader);
  }
  return result;
}

}  // namespace tessera::calibrate
