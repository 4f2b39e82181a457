#include "firmware/vehicle/ellipse_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tessera::firmware {
namespace {

constexpr std::size_t kUnknowns = 5;
constexpr std::size_t kFewest = 8;
using Row = std::array<float, kUnknowns + 1>;  // coefficients, then the right-hand side
using Equations = std::array<Row, kUnknowns>;

// Centre and spread of the samples: the fit works on numbers near one, so that single precision suffices.
struct Frame {
  float x = 0.0F;
  float y = 0.0F;
  float scale = 1.0F;
};

Frame frameOf(std::span<const Field> samples) {
  Frame f;
  const auto n = static_cast<float>(samples.size());
  for (const Field& s : samples) {
    f.x += s.x / n;
    f.y += s.y / n;
  }
  float sum = 0.0F;
  for (const Field& s : samples) sum += (s.x - f.x) * (s.x - f.x) + (s.y - f.y) * (s.y - f.y);
  f.scale = std::sqrt(sum / n);
  return f;
}

// Gauss' elimination with pivots by column; false when the equations do not determine the unknowns.
bool solve(Equations& m, std::array<float, kUnknowns>& x) {
  for (std::size_t col = 0; col < kUnknowns; ++col) {
    std::size_t best = col;
    for (std::size_t row = col + 1; row < kUnknowns; ++row)
      if (std::fabs(m[row][col]) > std::fabs(m[best][col])) best = row;
    if (!(std::fabs(m[best][col]) > 1e-5F)) return false;
    std::swap(m[col], m[best]);
    for (std::size_t row = col + 1; row < kUnknowns; ++row) {
      const float factor = m[row][col] / m[col][col];
      for (std::size_t k = col; k <= kUnknowns; ++k) m[row][k] -= factor * m[col][k];
    }
  }
  for (std::size_t row = kUnknowns; row-- > 0;) {
    float rest = m[row][kUnknowns];
    for (std::size_t k = row + 1; k < kUnknowns; ++k) rest -= m[row][k] * x[k];
    x[row] = rest / m[row][row];
  }
  return true;
}

// With A = 1/2 + a and C = 1/2 - a: a (x² - y²) + B x y + D x + E y + F = -(x² + y²) / 2.
bool fitConic(std::span<const Field> samples, const Frame& f, std::array<float, kUnknowns>& conic) {
  Equations normal{};
  for (const Field& s : samples) {
    const float x = (s.x - f.x) / f.scale;
    const float y = (s.y - f.y) / f.scale;
    const Row row{x * x - y * y, x * y, x, y, 1.0F, -0.5F * (x * x + y * y)};
    for (std::size_t i = 0; i < kUnknowns; ++i)
      for (std::size_t j = 0; j <= kUnknowns; ++j) normal[i][j] += row[i] * row[j] / static_cast<float>(samples.size());
  }
  return solve(normal, conic);
}

float misfitOf(std::span<const Field> samples, const EllipseFit& fit) {
  float sum = 0.0F;
  for (const Field& s : samples) {
    const Field c = fit.correction.apply(s);
    const float off = std::sqrt(c.x * c.x + c.y * c.y) / fit.radius - 1.0F;
    sum += off * off;
  }
  return std::sqrt(sum / static_cast<float>(samples.size()));
}

}  // namespace

std::optional<EllipseFit> fitEllipse(std::span<const Field> samples) {
  if (samples.size() < kFewest) return std::nullopt;
  const Frame frame = frameOf(samples);
  if (!(frame.scale > 0.0F)) return std::nullopt;
  std::array<float, kUnknowns> conic{};
  if (!fitConic(samples, frame, conic)) return std::nullopt;
  const float a = 0.5F + conic[0];
  const float b = conic[1];
  const float c = 0.5F - conic[0];
  const float discriminant = 4.0F * a * c - b * b;
  if (!(discriminant > 1e-4F)) return std::nullopt;
  const float x = (b * conic[3] - 2.0F * c * conic[2]) / discriminant;
  const float y = (b * conic[2] - 2.0F * a * conic[3]) / discriminant;
  const float level = -(conic[4] + 0.5F * (conic[2] * x + conic[3] * y));
  if (!(level > 0.0F)) return std::nullopt;
  // N = [n11 n12; n12 n22] has the half axes' inverse squares as eigenvalues; its root maps the ellipse to a circle.
  const float n11 = a / level;
  const float n12 = 0.5F * b / level;
  const float n22 = c / level;
  const float det = std::sqrt(n11 * n22 - n12 * n12);
  const float trace = std::sqrt(n11 + n22 + 2.0F * det);
  const float radius = 1.0F / std::sqrt(det);
  const float half = 0.5F * (n11 + n22);
  const float spread = std::sqrt(0.25F * (n11 - n22) * (n11 - n22) + n12 * n12);
  EllipseFit fit;
  fit.radius = radius * frame.scale;
  fit.axisRatio = std::sqrt((half + spread) / std::max(half - spread, 1e-6F));
  fit.correction.offsetX = frame.x + x * frame.scale;
  fit.correction.offsetY = frame.y + y * frame.scale;
  fit.correction.xx = radius * (n11 + det) / trace;
  fit.correction.xy = fit.correction.yx = radius * n12 / trace;
  fit.correction.yy = radius * (n22 + det) / trace;
  fit.misfit = misfitOf(samples, fit);
  return fit;
}

}  // namespace tessera::firmware
