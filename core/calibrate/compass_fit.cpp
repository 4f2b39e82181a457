#include "calibrate/compass_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <string>

#include "base/angle.h"

namespace tessera::calibrate {
namespace {

constexpr std::size_t kFewestPoints = 6;
constexpr double kRoundOff = 1e-13;    // of points near one
constexpr double kLeastSpread = 1e-3;  // µT; far below the chip's step
// The vehicle's own limits (firmware/vehicle/compass_calibration.cpp): what is written here it would take as well.
constexpr double kWorstMisfit = 0.05;  // 3 degrees
constexpr double kWorstAxisRatio = 4.0;
constexpr double kWeakestField = 10.0;  // µT; the earth's is 20 to 42 between the polar circles
constexpr double kStrongestField = 60.0;

// A x² + B xy + C y² + D x + E y + F = 0
using Conic = Eigen::Matrix<double, 6, 1>;

// Centre and spread: the fit works on numbers near one.
struct Frame {
  double x = 0.0;
  double y = 0.0;
  double scale = 0.0;
};

Frame frameOf(std::span<const FieldPoint> points) {
  Frame frame;
  const auto n = static_cast<double>(points.size());
  for (const FieldPoint& p : points) {
    frame.x += p.x / n;
    frame.y += p.y / n;
  }
  double sum = 0.0;
  for (const FieldPoint& p : points) sum += (p.x - frame.x) * (p.x - frame.x) + (p.y - frame.y) * (p.y - frame.y);
  frame.scale = std::sqrt(sum / n);
  return frame;
}

// The scatter matrix in blocks, so that its singular part, D x + E y + F, is eliminated first.
std::optional<Conic> fitConic(std::span<const FieldPoint> points, const Frame& frame) {
  Eigen::Matrix3d s1 = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d s2 = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d s3 = Eigen::Matrix3d::Zero();
  for (const FieldPoint& p : points) {
    const double x = (p.x - frame.x) / frame.scale;
    const double y = (p.y - frame.y) / frame.scale;
    const Eigen::Vector3d square{x * x, x * y, y * y};
    const Eigen::Vector3d line{x, y, 1.0};
    s1 += square * square.transpose();
    s2 += square * line.transpose();
    s3 += line * line.transpose();
  }
  const Eigen::LLT<Eigen::Matrix3d> line{s3};
  if (line.info() != Eigen::Success || line.rcond() < 1e-9) return std::nullopt;  // on a line
  const Eigen::Matrix3d eliminated = -line.solve(s2.transpose());
  Eigen::Matrix3d m = s1 + s2 * eliminated;
  m.diagonal().array() += kRoundOff * s1.trace();  // points on the very ellipse leave it without an inverse
  Eigen::Matrix3d constraint;                      // 4 A C - B² = 1
  constraint << 0.0, 0.0, 2.0, 0.0, -1.0, 0.0, 2.0, 0.0, 0.0;
  // Of the pencil's three eigenvalues, as of the constraint's own, one is positive: the last, and the ellipse is its
  // vector.
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix3d> solver{constraint, m};
  if (solver.info() != Eigen::Success) return std::nullopt;
  const Eigen::Vector3d a = solver.eigenvectors().col(2);
  Conic conic;
  conic << a, eliminated * a;
  return conic;
}

}  // namespace

FieldPoint CompassCorrection::apply(FieldPoint measured) const {
  const double x = measured.x - offsetX;
  const double y = measured.y - offsetY;
  return {xx * x + xy * y, yx * x + yy * y};
}

std::vector<FieldPoint> FieldEllipse::outline(int points) const {
  std::vector<FieldPoint> all;
  for (int i = 0; i <= points; ++i) {
    const double at = 2.0 * kPi * i / points;
    const double along = longAxis * std::cos(at);
    const double aside = shortAxis * std::sin(at);
    all.push_back({centre.x + along * std::cos(angle) - aside * std::sin(angle),
                   centre.y + along * std::sin(angle) + aside * std::cos(angle)});
  }
  return all;
}

std::optional<FieldEllipse> fitEllipse(std::span<const FieldPoint> points) {
  if (points.size() < kFewestPoints) return std::nullopt;
  const Frame frame = frameOf(points);
  if (!(frame.scale > kLeastSpread)) return std::nullopt;
  const auto conic = fitConic(points, frame);
  if (!conic) return std::nullopt;
  Eigen::Matrix2d shape;
  shape << (*conic)[0], (*conic)[1] / 2.0, (*conic)[1] / 2.0, (*conic)[2];
  const Eigen::Vector2d linear{(*conic)[3], (*conic)[4]};
  const Eigen::Vector2d centre = -0.5 * shape.inverse() * linear;
  const double level = -((*conic)[5] + 0.5 * linear.dot(centre));
  // Its eigenvalues are the half axes' inverse squares, the smallest, of the long axis, first.
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
  axes.computeDirect(shape / level);
  if (!(axes.eigenvalues()[0] > 0.0)) return std::nullopt;
  FieldEllipse ellipse;
  ellipse.centre = {frame.x + frame.scale * centre.x(), frame.y + frame.scale * centre.y()};
  ellipse.longAxis = frame.scale / std::sqrt(axes.eigenvalues()[0]);
  ellipse.shortAxis = frame.scale / std::sqrt(axes.eigenvalues()[1]);
  ellipse.angle = std::atan2(axes.eigenvectors()(1, 0), axes.eigenvectors()(0, 0));
  return ellipse;
}

std::optional<CompassFit> fitCompass(std::span<const FieldPoint> points) {
  const auto ellipse = fitEllipse(points);
  if (!ellipse) return std::nullopt;
  CompassFit fit;
  fit.ellipse = *ellipse;
  fit.radius = std::sqrt(ellipse->longAxis * ellipse->shortAxis);
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd{ellipse->angle}.toRotationMatrix();
  const Eigen::Vector2d stretch{fit.radius / ellipse->longAxis, fit.radius / ellipse->shortAxis};
  const Eigen::Matrix2d matrix = turn * stretch.asDiagonal() * turn.transpose();
  fit.correction = {ellipse->centre.x, ellipse->centre.y, matrix(0, 0), matrix(0, 1), matrix(1, 0), matrix(1, 1)};
  double sum = 0.0;
  for (const FieldPoint& p : points) {
    const FieldPoint c = fit.correction.apply(p);
    const double off = std::hypot(c.x, c.y) / fit.radius - 1.0;
    sum += off * off;
    const double share = (std::atan2(c.y, c.x) + kPi) / (2.0 * kPi);
    fit.met[std::min(static_cast<std::size_t>(share * CompassFit::kSectors), CompassFit::kSectors - 1)] = true;
  }
  fit.misfit = std::sqrt(sum / static_cast<double>(points.size()));
  return fit;
}

int CompassFit::missing() const { return static_cast<int>(std::count(met.begin(), met.end(), false)); }

std::optional<Sentence> CompassFit::objection() const {
  if (const int without = missing(); without > 0)
    return phrase("Core", "In %1 of %2 directions nothing was measured: the vehicle did not turn all around.")
        .with(without, kSectors);
  if (radius < kWeakestField || radius > kStrongestField)
    return phrase("Core",
                  "A horizontal field of %1 µT cannot be the earth's: iron, magnets or currents are too near, or the "
                  "compass does not lie level.")
        .with(std::lround(radius));
  if (ellipse.longAxis > kWorstAxisRatio * ellipse.shortAxis)
    return phrase("Core",
                  "The ellipse is %1 times as long as wide: iron sits right beside the compass. Mount it elsewhere.")
        .with(std::lround(ellipse.longAxis / ellipse.shortAxis));
  if (misfit > kWorstMisfit)
    return phrase(
               "Core",
               "The points lie on no ellipse: they are off by %1 % of the field. Something has moved or was switched "
               "meanwhile, or steel stands near.")
        .with(std::lround(100.0 * misfit));
  return std::nullopt;
}

double largestTurn(const CompassCorrection& a, const CompassCorrection& b, std::span<const FieldPoint> points) {
  double largest = 0.0;
  for (const FieldPoint& p : points) {
    const FieldPoint one = a.apply(p);
    const FieldPoint other = b.apply(p);
    largest =
        std::max(largest, std::abs(std::atan2(one.x * other.y - one.y * other.x, one.x * other.x + one.y * other.y)));
  }
  return largest;
}

}  // namespace tessera::calibrate
