#include "locate/particle_cloud.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace tessera::locate {
namespace {

constexpr double kCloudOutlier = 1e-3;        // chance that a read says nothing (mistimed, of another tag)
constexpr double kCloudLeastVariance = 1e-8;  // m², rad²; nothing is known better than this

/// e^v to 2e-4, for v in ±30: two to the whole part by the bits of a number, a polynomial for the rest.
double quickExp(double v) {
  const double t = std::clamp(v, -30.0, 30.0) * 1.4426950408889634;
  const double whole = std::floor(t);
  const double f = t - whole;
  const double part = 1.0 + f * (0.695976 + f * (0.224941 + f * 0.0790844));
  return part * std::bit_cast<double>(static_cast<std::int64_t>(whole + 1023.0) << 52);
}

double quickLogistic(double z) { return 1.0 / (1.0 + quickExp(z)); }

}  // namespace

ParticleCloud::ParticleCloud(const ParticleOptions& options, std::size_t readers, std::uint64_t key)
    : options_{options}, random_{key} {
  const std::size_t n = std::max<std::size_t>(options_.count, 2);
  for (auto* values : {&x_, &y_, &bias_, &sinBias_, &inside_, &missed_, &scratch_, &wear_, &slip_, &fromX_, &fromY_})
    values->assign(n, 0.0);
  for (auto* values : {&scale_, &cosBias_, &unrest_}) values->assign(n, 1.0);
  weight_.assign(n, 1.0 / static_cast<double>(n));
  pass_.assign(readers, std::vector<double>(n, 1.0));
  chosen_.assign(n, 0);
  options_.levels = std::clamp<std::size_t>(options_.levels, 1, n);
  mass_.assign(options_.levels, 0.0);
  const double ratio = options_.mostUnrest / options_.leastUnrest;
  for (std::size_t level = 0; level < options_.levels; ++level) {
    const double up = level == 0 ? 0.0 : static_cast<double>(level) / static_cast<double>(options_.levels - 1);
    std::fill(unrest_.begin() + static_cast<std::ptrdiff_t>(beginOf(level)), unrest_.end(),
              options_.leastUnrest * std::pow(ratio, up));
  }
}

void ParticleCloud::scatter(Point where, double sigma, double bias, double biasSigma) {
  for (std::size_t i = 0; i < size(); ++i) {
    x_[i] = where.x.value() + sigma * random_.normal();
    y_[i] = where.y.value() + sigma * random_.normal();
    bias_[i] = bias + biasSigma * random_.normal();
    cosBias_[i] = std::cos(bias_[i]);
    sinBias_[i] = std::sin(bias_[i]);
    slip_[i] = unrest_[i] * random_.normal();
    wear_[i] = options_.wear * random_.normal();
    scale_[i] = 1.0 + wear_[i] + slip_[i];
  }
  std::fill(weight_.begin(), weight_.end(), 1.0 / static_cast<double>(size()));
  for (auto& pass : pass_) std::fill(pass.begin(), pass.end(), 1.0);
  settle();
}

// Newly set: where the last motion must have begun.
void ParticleCloud::settle() {
  for (std::size_t i = 0; i < size(); ++i) {
    fromX_[i] = x_[i] - scale_[i] * (cosBias_[i] * lastWay_.x() + sinBias_[i] * lastWay_.y());
    fromY_[i] = y_[i] - scale_[i] * (cosBias_[i] * lastWay_.y() - sinBias_[i] * lastWay_.x());
  }
}

void ParticleCloud::beginMotion() {
  fromX_ = x_;
  fromY_ = y_;
  lastWay_.setZero();
}

void ParticleCloud::scatterUnder(const Eigen::Vector2d& tag, const Eigen::Vector2d& lever, double radius, double bias,
                                 double biasSigma) {
  scatter({}, 0.0, bias, biasSigma);
  for (std::size_t i = 0; i < size(); ++i) {
    const double away = radius * std::sqrt(random_.uniform());
    const double angle = 2.0 * kPi * random_.uniform();
    x_[i] = tag.x() + away * std::cos(angle) - (cosBias_[i] * lever.x() + sinBias_[i] * lever.y());
    y_[i] = tag.y() + away * std::sin(angle) - (cosBias_[i] * lever.y() - sinBias_[i] * lever.x());
  }
  settle();
}

void ParticleCloud::move(const CloudStep& step) {
  const double slip = options_.slipPerRootMetre * std::sqrt(step.way);
  const double slipAlong = std::hypot(slip, options_.slipPerRootRadian * std::sqrt(std::abs(step.turn)));
  const double across = std::hypot(slip, step.chord * options_.turnShare * step.turn);
  const double drift =
      std::hypot(options_.biasPerRootMetre * step.calm * std::sqrt(step.way), options_.biasPerTurn * step.turn);
  // A vehicle that stands keeps its slip.
  const double keep = step.way > 0.0 ? std::exp(-step.seconds / options_.scaleMemory) : 1.0;
  const double fresh = std::sqrt(1.0 - keep * keep);
  const double c = std::cos(step.heading);
  const double s = std::sin(step.heading);
  lastWay_ += step.chord * Eigen::Vector2d{c, s};
  for (std::size_t i = 0; i < size(); ++i) {
    const double dBias = drift * random_.normal() + step.shift + step.pull * (step.toward - bias_[i]);
    // Half of the new bias acts on this step already: it changed on the way.
    const double cb = cosBias_[i] - 0.5 * dBias * sinBias_[i];
    const double sb = sinBias_[i] + 0.5 * dBias * cosBias_[i];
    const double slipped = keep * slip_[i] + fresh * unrest_[i] * random_.normal();
    const double scale = 1.0 + wear_[i] + 0.5 * (slip_[i] + slipped);
    slip_[i] = slipped;
    scale_[i] = 1.0 + wear_[i] + slipped;
    const double along = step.chord * scale + slipAlong * random_.normal();
    const double side = across * random_.normal();
    const double ch = c * cb + s * sb;
    const double sh = s * cb - c * sb;
    x_[i] += along * ch - side * sh;
    y_[i] += along * sh + side * ch;
    bias_[i] += dBias;
    // Turned on by the new bias, and kept at the length of 1.
    const double cn = cosBias_[i] - dBias * sinBias_[i];
    const double sn = sinBias_[i] + dBias * cosBias_[i];
    const double unit = 1.5 - 0.5 * (cn * cn + sn * sn);
    cosBias_[i] = cn * unit;
    sinBias_[i] = sn * unit;
  }
}

void ParticleCloud::roughen(double sigma) {
  for (std::size_t i = 0; i < size(); ++i) {
    const double dx = sigma * random_.normal();
    const double dy = sigma * random_.normal();
    x_[i] += dx;
    y_[i] += dy;
    fromX_[i] += dx;
    fromY_[i] += dy;
  }
}

void ParticleCloud::inDisc(const ReaderThen& reader, const Eigen::Vector2d& tag, double radius) {
  const double perRim = 1.0 / std::hypot(options_.rim, reader.rim);
  for (std::size_t i = 0; i < size(); ++i) {
    // The reader's place then is p + R(-bias)·(lever - scale·way): no particle is run through its past again. What it
    // did in its last motion is known better than by that.
    const double ux = reader.lever.x() - scale_[i] * reader.before.x();
    const double uy = reader.lever.y() - scale_[i] * reader.before.y();
    const double px = x_[i] - reader.back * (x_[i] - fromX_[i]);
    const double py = y_[i] - reader.back * (y_[i] - fromY_[i]);
    const double dx = px + cosBias_[i] * ux + sinBias_[i] * uy - tag.x();
    const double dy = py + cosBias_[i] * uy - sinBias_[i] * ux - tag.y();
    inside_[i] = quickLogistic((std::sqrt(dx * dx + dy * dy) - radius) * perRim);
  }
}

double ParticleCloud::chanceOf(const ReaderThen& reader, const Eigen::Vector2d& tag, double radius) {
  inDisc(reader, tag, radius);
  double chance = 0.0;
  for (std::size_t i = 0; i < size(); ++i) chance += weight_[i] * inside_[i];
  return chance;
}

void ParticleCloud::weighSeen(std::size_t readerIndex) {
  double sum = 0.0;
  for (std::size_t i = 0; i < size(); ++i) {
    weight_[i] *= kCloudOutlier + (1.0 - kCloudOutlier) * inside_[i];
    sum += weight_[i];
  }
  normalise(sum);
  newPass(readerIndex);
}

double ParticleCloud::weighSilent(std::size_t readerIndex, const ReaderThen& reader,
                                  std::span<const Eigen::Vector2d> tags, double radius) {
  if (tags.empty()) {
    newPass(readerIndex);
    return 1.0;
  }
  std::fill(missed_.begin(), missed_.end(), 1.0);
  for (const Eigen::Vector2d& tag : tags) {
    inDisc(reader, tag, radius);
    for (std::size_t i = 0; i < size(); ++i) missed_[i] *= 1.0 - options_.detection * inside_[i];
  }
  std::vector<double>& pass = pass_[readerIndex];
  const double dead = options_.deadTag;
  double sum = 0.0;
  for (std::size_t i = 0; i < size(); ++i) {
    const double before = dead + (1.0 - dead) * pass[i];
    // Where no tag is near, a pass is over, and the next begins with nothing held against it.
    pass[i] = missed_[i] > 0.99 ? 1.0 : pass[i] * missed_[i];
    const double after = missed_[i] > 0.99 ? before * missed_[i] : dead + (1.0 - dead) * pass[i];
    weight_[i] *= after / before;
    sum += weight_[i];
  }
  normalise(sum);
  return sum;
}

void ParticleCloud::newPass(std::size_t readerIndex) {
  std::fill(pass_[readerIndex].begin(), pass_[readerIndex].end(), 1.0);
}

void ParticleCloud::normalise(double sum) {
  const auto n = static_cast<double>(size());
  if (!(sum > 1e-200)) {
    std::fill(weight_.begin(), weight_.end(), 1.0 / n);
    return;
  }
  for (double& w : weight_) w /= sum;
}

std::vector<Point> ParticleCloud::sample(std::size_t most) const {
  std::vector<Point> places;
  const std::size_t count = std::min(most, size());
  places.reserve(count);
  double below = weight_[0];
  std::size_t from = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double pick = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    while (pick > below && from + 1 < size()) below += weight_[++from];
    places.push_back({Metres{x_[from]}, Metres{y_[from]}});
  }
  return places;
}

ParticleCloud::Moments ParticleCloud::moments() const {
  Moments m;
  for (std::size_t i = 0; i < size(); ++i) m.mean += weight_[i] * Eigen::Vector4d{x_[i], y_[i], bias_[i], scale_[i]};
  for (std::size_t i = 0; i < size(); ++i) {
    const Eigen::Vector4d off = Eigen::Vector4d{x_[i], y_[i], bias_[i], scale_[i]} - m.mean;
    m.covariance += weight_[i] * off * off.transpose();
  }
  m.covariance.diagonal().array() += kCloudLeastVariance;
  return m;
}

}  // namespace tessera::locate
