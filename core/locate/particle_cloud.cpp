#include "locate/particle_cloud.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace tessera::locate {
namespace {

constexpr double kCloudOutlier = 1e-3;        // chance that a read says nothing (mistimed, of another tag)
constexpr double kCloudLeastVariance = 1e-8;  // m², rad²; nothing is known better than this
constexpr double kResampleBelow = 0.5;        // share of effective particles (Liu, Chen 1995)

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
  for (auto* values : {&x_, &y_, &bias_, &sinBias_, &inside_, &missed_, &scratch_}) values->assign(n, 0.0);
  for (auto* values : {&scale_, &cosBias_, &unrest_}) values->assign(n, 1.0);
  weight_.assign(n, 1.0 / static_cast<double>(n));
  pass_.assign(readers, std::vector<double>(n, 1.0));
  chosen_.assign(n, 0);
}

void ParticleCloud::scatter(Point where, double sigma, double bias, double biasSigma) {
  for (std::size_t i = 0; i < size(); ++i) {
    x_[i] = where.x.value() + sigma * random_.normal();
    y_[i] = where.y.value() + sigma * random_.normal();
    bias_[i] = bias + biasSigma * random_.normal();
    cosBias_[i] = std::cos(bias_[i]);
    sinBias_[i] = std::sin(bias_[i]);
    unrest_[i] = options_.leastUnrest * std::pow(options_.mostUnrest / options_.leastUnrest, random_.uniform());
    scale_[i] = 1.0 + unrest_[i] * random_.normal();
  }
  std::fill(weight_.begin(), weight_.end(), 1.0 / static_cast<double>(size()));
  for (auto& pass : pass_) std::fill(pass.begin(), pass.end(), 1.0);
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
}

void ParticleCloud::move(const CloudStep& step) {
  const double slip = options_.slipPerRootMetre * std::sqrt(step.way);
  const double across = std::hypot(slip, step.chord * options_.turnShare * step.turn);
  const double drift = std::hypot(options_.biasPerRootMetre * std::sqrt(step.way), options_.biasPerTurn * step.turn);
  const double keep = std::exp(-step.way / options_.scaleLength);
  const double fresh = std::sqrt(1.0 - keep * keep);
  const double c = std::cos(step.heading);
  const double s = std::sin(step.heading);
  for (std::size_t i = 0; i < size(); ++i) {
    // Half of the new bias acts on this step already: it changed on the way.
    const double dBias = drift * random_.normal();
    const double cb = cosBias_[i] - 0.5 * dBias * sinBias_[i];
    const double sb = sinBias_[i] + 0.5 * dBias * cosBias_[i];
    const double along = step.chord * scale_[i] + slip * random_.normal();
    const double side = across * random_.normal();
    const double ch = c * cb + s * sb;
    const double sh = s * cb - c * sb;
    x_[i] += along * ch - side * sh;
    y_[i] += along * sh + side * ch;
    bias_[i] += dBias;
    cosBias_[i] = std::cos(bias_[i]);
    sinBias_[i] = std::sin(bias_[i]);
    scale_[i] = 1.0 + keep * (scale_[i] - 1.0) + fresh * unrest_[i] * random_.normal();
  }
}

void ParticleCloud::roughen(double sigma) {
  for (std::size_t i = 0; i < size(); ++i) {
    x_[i] += sigma * random_.normal();
    y_[i] += sigma * random_.normal();
  }
}

void ParticleCloud::inDisc(const ReaderThen& reader, const Eigen::Vector2d& tag, double radius) {
  const double perRim = 1.0 / options_.rim;
  for (std::size_t i = 0; i < size(); ++i) {
    // The reader's place then is p + R(-bias)·(lever - scale·way): no particle is run through its past again.
    const double ux = reader.lever.x() - scale_[i] * reader.way.x();
    const double uy = reader.lever.y() - scale_[i] * reader.way.y();
    const double dx = x_[i] + cosBias_[i] * ux + sinBias_[i] * uy - tag.x();
    const double dy = y_[i] + cosBias_[i] * uy - sinBias_[i] * ux - tag.y();
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

void ParticleCloud::gather(std::vector<double>& values) {
  for (std::size_t i = 0; i < size(); ++i) scratch_[i] = values[chosen_[i]];
  values.swap(scratch_);
}

void ParticleCloud::resampleIfNeeded() {
  const auto n = static_cast<double>(size());
  double squares = 0.0;
  for (const double w : weight_) squares += w * w;
  if (squares * n * kResampleBelow < 1.0) return;
  const Moments before = moments();
  // Systematic: one random number, evenly spaced picks (Kitagawa 1996).
  double below = weight_[0];
  std::size_t from = 0;
  const double first = random_.uniform();
  for (std::size_t i = 0; i < size(); ++i) {
    const double pick = (static_cast<double>(i) + first) / n;
    while (pick > below && from + 1 < size()) below += weight_[++from];
    chosen_[i] = from;
  }
  for (auto* values : {&x_, &y_, &bias_, &scale_, &unrest_}) gather(*values);
  for (auto& pass : pass_) gather(pass);
  std::fill(weight_.begin(), weight_.end(), 1.0 / n);
  // Copies are moved apart by a kernel that keeps mean and spread (Liu, West 2001).
  const double h = options_.roughening;
  const double keep = std::sqrt(1.0 - h * h);
  std::size_t k = 0;
  for (auto* values : {&x_, &y_, &bias_, &scale_}) {
    const auto index = static_cast<Eigen::Index>(k++);
    const double mean = before.mean(index);
    const double sigma = h * std::sqrt(std::max(0.0, before.covariance(index, index)));
    for (double& v : *values) v = mean + keep * (v - mean) + sigma * random_.normal();
  }
  for (std::size_t i = 0; i < size(); ++i) {
    cosBias_[i] = std::cos(bias_[i]);
    sinBias_[i] = std::sin(bias_[i]);
    unrest_[i] = std::clamp(unrest_[i] * (1.0 + h * random_.normal()), options_.leastUnrest, options_.mostUnrest);
  }
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
