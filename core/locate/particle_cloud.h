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
  std::size_t count = 1200;
  // How the vehicle moves.
  double startSigma = 0.05;          ///< m, of a start pose
  double biasSigma = 0.07;           ///< rad, of the compass bias at the start
  double biasPerRootMetre = 0.08;    ///< rad/√m: the floor's magnetic field changes from place to place
  double biasPerTurn = 0.02;         ///< rad per rad: what is left of soft iron changes with the heading
  double wear = 0.08;                ///< share, of the odometer's scale that stays: wheels' diameter, lasting slip
  double leastUnrest = 0.015;        ///< share by which the scale wanders (slip), as the calmest particles have it ...
  double mostUnrest = 0.15;          ///< ... and the wildest
  std::size_t levels = 3;            ///< of unrest, from the one to the other, with as many particles each
  double levelChange = 0.03;         ///< chance, from resampling to resampling, that the unrest is another
  double scaleMemory = 0.5;          ///< s, over which that wandering is forgotten
  double slipPerRootMetre = 0.002;   ///< m/√m, of the wheels, in each direction
  double slipPerRootRadian = 0.004;  ///< m/√rad, along, of a turn on the spot: its wheels slip unequally
  double turnShare = 0.1;            ///< of a heading change between two samples: doubt about the heading meanwhile
  double longestPiece = 0.02;        ///< m, of the way that is moved at once
  // What a reader sees.
  double rim = 0.005;  ///< m, logistic width of the disc's edge
  double instant =
      0.010;  ///< s, by which the instants of attempts are off: blurs the edge the more, the faster it goes
  double detection = 0.82;  ///< chance that an attempt inside the disc succeeds; a little below the truth is safe
  double deadTag = 0.02;    ///< chance that a tag of the map answers nobody
  double readLag = 0.020;   ///< s from a reader's asking the floor to the instant told: its result waits for the bus
  // When the picture is wrong.
  double gate = 2e-3;       ///< a read less likely than this contradicts the estimate
  double poorSigma = 0.01;  ///< m, more doubt about the place where hardly a particle is left that explains what came
  double largestSigma = 0.20;  ///< m: with more doubt about the place it does not count as located
  double roughening = 0.10;    ///< share of the spread by which resampled particles are moved apart
};

/// Movement between two instants, as the odometer and the compass report it.
struct CloudStep {
  double chord = 0.0;    ///< m
  double way = 0.0;      ///< m, never negative
  double heading = 0.0;  ///< rad, reported, in the middle
  double turn = 0.0;     ///< rad
  double seconds = 0.0;  ///< that it took
  double calm = 1.0;     ///< times that the bias wanders (ParticleOptions::biasPerRootMetre)
  double shift = 0.0;    ///< rad, change of the bias that is foreseen
  double pull = 0.0;     ///< share by which the bias ...
  double toward = 0.0;   ///< rad, ... goes back to this
};

/// Where a reader stood at an earlier instant, seen from where the vehicle is now, before bias and scale are taken out.
struct ReaderThen {
  Eigen::Vector2d lever = Eigen::Vector2d::Zero();  ///< from the vehicle to the reader, by the reported heading then
  Eigen::Vector2d way = Eigen::Vector2d::Zero();    ///< driven since, by the reported headings
  /// Of the way, what was driven before the cloud's last motion; then by each particle's scale.
  Eigen::Vector2d before = Eigen::Vector2d::Zero();
  double back = 0.0;  ///< share of the last motion that came since; each particle knows how it moved
  double rim = 0.0;   ///< m, more by which the disc's edge is blurred
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
  /// What was driven in the last motion, where this cloud was not there to be moved.
  void moved(const Eigen::Vector2d& way) { lastWay_ = way; }
  /// A motion begins, which move() tells in one piece or several.
  void beginMotion();
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
  /// Index of the first particle that takes its odometer to be this unruly.
  [[nodiscard]] std::size_t beginOf(std::size_t level) const { return level * size() / options_.levels; }
  /// How many particles carry the weight, as a share; how likely the levels are goes into mass_.
  double effectiveShare();
  void draw(std::size_t level, double own, double any);
  void moveApart(std::size_t begin, std::size_t end);
  void settle();
  void normalise(double sum);
  void gather(std::vector<double>& values);

  ParticleOptions options_;
  CounterRandom random_;
  std::vector<double> x_, y_, bias_, scale_, weight_;
  std::vector<double> wear_, slip_;                    ///< what makes up the scale: what stays of it, and what wanders
  std::vector<double> fromX_, fromY_;                  ///< where the last motion began
  Eigen::Vector2d lastWay_ = Eigen::Vector2d::Zero();  ///< driven in that motion, by the reported headings
  std::vector<double> cosBias_, sinBias_;              ///< kept beside: asked at every attempt of every reader
  /// Per reader: chance of the silence so far if the tag now passed is alive. A dead tag explains any number of silent
  /// attempts at once, so they are no independent evidence.
  std::vector<std::vector<double>> pass_;
  /// How much a particle takes its odometer's scale to wander, by its level; and how likely each level is.
  std::vector<double> unrest_, mass_;
  std::vector<double> inside_, missed_, scratch_;
  std::vector<std::size_t> chosen_;
};

}  // namespace tessera::locate
