// Particles are drawn anew by their weights, each level of unrest for itself.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "locate/particle_cloud.h"

namespace tessera::locate {
namespace {

constexpr double kResampleBelow = 0.5;  // share of effective particles (Liu, Chen 1995)
// Where so few carry the weight, their spread says nothing of the doubt: evidence came that hardly any foresaw.
constexpr double kFewest = 20.0;

}  // namespace

void ParticleCloud::gather(std::vector<double>& values) {
  for (std::size_t i = 0; i < size(); ++i) scratch_[i] = values[chosen_[i]];
  values.swap(scratch_);
}

double ParticleCloud::effectiveShare() {
  double share = 0.0;
  for (std::size_t level = 0; level < options_.levels; ++level) {
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t i = beginOf(level); i < beginOf(level + 1); ++i) {
      sum += weight_[i];
      squares += weight_[i] * weight_[i];
    }
    mass_[level] = sum;
    if (squares > 0.0) share += sum * sum * sum / squares / static_cast<double>(beginOf(level + 1) - beginOf(level));
  }
  return share;
}

void ParticleCloud::resampleIfNeeded() {
  if (effectiveShare() > kResampleBelow) return;
  double squares = 0.0;
  for (const double w : weight_) squares += w * w;
  // Every level keeps its particles, so that how likely it is can be learned and never dies out by chance: each draws
  // from its own and, as the unrest may have changed, from all (interacting multiple models: Blom, Bar-Shalom 1988).
  const double come = options_.levelChange / static_cast<double>(options_.levels);
  for (std::size_t level = 0; level < options_.levels; ++level) {
    const double stay = (1.0 - options_.levelChange) * mass_[level];
    draw(level, mass_[level] > 0.0 ? stay / (stay + come) / mass_[level] : 0.0, come / (stay + come));
    mass_[level] = stay + come;
  }
  for (auto* values : {&x_, &y_, &bias_, &wear_, &slip_, &fromX_, &fromY_}) gather(*values);
  for (auto& pass : pass_) gather(pass);
  for (std::size_t level = 0; level < options_.levels; ++level) {
    const std::size_t begin = beginOf(level);
    const std::size_t end = beginOf(level + 1);
    const double weight = mass_[level] / static_cast<double>(end - begin);
    for (std::size_t i = begin; i < end; ++i) weight_[i] = weight;
    moveApart(begin, end);
  }
  if (squares * kFewest > 1.0) roughen(options_.poorSigma);
}

// Systematic: one random number, evenly spaced picks (Kitagawa 1996); weights count `own` more in the level itself.
void ParticleCloud::draw(std::size_t level, double own, double any) {
  const std::size_t begin = beginOf(level);
  const std::size_t end = beginOf(level + 1);
  const auto weightOf = [&](std::size_t i) { return weight_[i] * (i >= begin && i < end ? own + any : any); };
  const double step = 1.0 / static_cast<double>(end - begin);
  double pick = step * random_.uniform();
  double below = weightOf(0);
  std::size_t from = 0;
  for (std::size_t i = begin; i < end; ++i, pick += step) {
    while (pick > below && from + 1 < size()) below += weightOf(++from);
    chosen_[i] = from;
  }
}

// Copies are moved apart by a kernel that keeps mean and spread (Liu, West 2001).
void ParticleCloud::moveApart(std::size_t begin, std::size_t end) {
  const double h = options_.roughening;
  const double keep = std::sqrt(1.0 - h * h);
  const auto n = static_cast<double>(end - begin);
  const auto apart = [&](std::vector<double>& values, double* follow) {
    double mean = 0.0;
    double variance = 0.0;
    for (std::size_t i = begin; i < end; ++i) mean += values[i] / n;
    for (std::size_t i = begin; i < end; ++i) variance += (values[i] - mean) * (values[i] - mean) / n;
    const double sigma = h * std::sqrt(variance);
    for (std::size_t i = begin; i < end; ++i) {
      const double moved = mean + keep * (values[i] - mean) + sigma * random_.normal();
      if (follow != nullptr) follow[i] += moved - values[i];
      values[i] = moved;
    }
  };
  apart(x_, fromX_.data());
  apart(y_, fromY_.data());
  for (auto* values : {&bias_, &wear_, &slip_}) apart(*values, nullptr);
  for (std::size_t i = begin; i < end; ++i) {
    scale_[i] = 1.0 + wear_[i] + slip_[i];
    cosBias_[i] = std::cos(bias_[i]);
    sinBias_[i] = std::sin(bias_[i]);
  }
}

}  // namespace tessera::locate
