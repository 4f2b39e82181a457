// A belief about one vehicle as weighted guesses (particles): place, compass bias and odometer scale of each, kept as
// one array per quantity so that every pass runs straight through memory. What it does not know is whose tags they are:
// that is the locator's (Thrun, Burgard, Fox, "Probabilistic Robotics", chapters 4 and 8).
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "base/pose.h"
#include "locate/counter_random.h"

namespace tessera::locate {

struct ParticleOptions {
  std::size_t count = 600;
  // How the vehicle moves.
  double startSigma = 0.05;         ///< m, of a start pose
  double biasSigma = 0.07;          ///< rad, of the compass bias at the start
  double biasPerRootMetre = 0.10;   ///< rad/√m: the floor's magnetic field changes from place to place
  double biasPerTurn = 0.02;        ///< rad per rad: what is left of soft iron changes with the heading
  double leastUnrest = 0.010;       ///< share by which the odometer's scale (wheel wear, slip) may wander: learned, ...
  double mostUnrest = 0.12;         ///< ... between these
  double scaleLength = 0.2;         ///< m, over which the scale is forgotten
  double slipPerRootMetre = 0.006;  ///< m/√m, of the wheels, in each direction
  double turnShare = 0.1;           ///< of a heading change between two samples: doubt about the direction meanwhile
  // What a reader sees.
  double rim = 0.0055;      ///< m, logistic width of the disc's edge, with what the instants of reads are off by
  double detection = 0.80;  ///< chance that an attempt inside the disc succeeds; a little below the truth is safe
  double deadTag = 0.03;    ///< chance that a tag of the map answers nobody
  double readLag = 0.020;   ///< s from a reader's asking the floor to the instant told: its result waits for the bus
  // When the picture is wrong.
  double gate = 2e-3;           ///< a read less likely than this contradicts the estimate
  double surprise = 0.05;       ///< a read less likely than this is taken in with more doubt about the place
  double surpriseSigma = 0.02;  ///< m, that doubt
  double largestSigma = 0.20;   ///< m: with more doubt about the place it does not count as located
  double roughening = 0.10;     ///< share of the spread by which resampled particles are moved apart
};

/// Movement between two instants, as the odometer and the compass report it.
struct CloudStep {
  double chord = 0.0;    ///< m
  double way = 0.0;      ///< m, never negative
  double heading = 0.0;  ///< rad, reported, in the middle
  double turn = 0.0;     ///< rad
};

/// Where a reader stood at an earlier instant, seen from where the vehicle is now, before bias and scale are taken out.
struct ReaderThen {
  Eigen::Vector2d lever = Eigen::Vector2d::Zero();  ///< from the vehicle to the reader, by the reported heading then
  Eigen::Vector2d way = Eigen::Vector2d::Zero();    ///< driven since, by the reported headings
};

class ParticleCloud {
public:
  struct Moments {
    Eigen::Vector4d mean = Eigen::Vector4d::Zero();        ///< x, y, bias, scale
    Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();  ///< of these
  };

  ParticleCloud(const ParticleOptions& options, std::size_t readers, std::uint64_t key);

  /// All around a place; bias and scale as far as they are known.
  void scatter(Point where, double sigma, double bias, double biasSigma);
  /// All over the disc of a tag that a reader reads.
  void scatterUnder(const Eigen::Vector2d& tag, const Eigen::Vector2d& lever, double radius, double bias,
                    double biasSigma);
  void move(const CloudStep& step);
  /// Doubt: moves every particle at random.
  void roughen(double sigma);

  /// Chance, under the belief, that the tag lies in the reader's disc then; changes nothing.
  [[nodiscard]] double chanceOf(const ReaderThen& reader, const Eigen::Vector2d& tag, double radius);
  /// Weighs by what chanceOf() asked last: the tag was seen.
  void weighSeen(std::size_t readerIndex);
  /// Weighs by an attempt that saw none of these tags. Returns the chance of that beforehand.
  double weighSilent(std::size_t readerIndex, const ReaderThen& reader, std::span<const Eigen::Vector2d> tags,
                     double radius);
  /// The reader's next silence is about another pass over a tag.
  void newPass(std::size_t readerIndex);
  /// Draws anew where few particles carry the weight.
  void resampleIfNeeded();

  [[nodiscard]] Moments moments() const;
  [[nodiscard]] std::size_t size() const { return x_.size(); }
  [[nodiscard]] std::span<const double> x() const { return x_; }
  [[nodiscard]] std::span<const double> y() const { return y_; }
  /// `most` places at most, each as often as it is likely; draws no random number.
  [[nodiscard]] std::vector<Point> sample(std::size_t most) const;

private:
  void inDisc(const ReaderThen& reader, const Eigen::Vector2d& tag, double radius);
  void normalise(double sum);
  void gather(std::vector<double>& values);

  ParticleOptions options_;
  CounterRandom random_;
  std::vector<double> x_, y_, bias_, scale_, weight_;
  std::vector<double> unrest_;             ///< how much a particle takes its odometer's scale to wander, as a share
  std::vector<double> cosBias_, sinBias_;  ///< kept beside: asked at every attempt of every reader
  /// Per reader: chance of the silence so far if the tag now passed is alive. A dead tag explains any number of silent
  /// attempts at once, so they are no independent evidence.
  std::vector<std::vector<double>> pass_;
  std::vector<double> inside_, missed_, scratch_;
  std::vector<std::size_t> chosen_;
};

}  // namespace tessera::locate
