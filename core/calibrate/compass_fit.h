// What a vehicle's own iron does to its compass, from the fields that it measured while it turned on the spot: they lie
// on an ellipse, whose centre is the hard iron and whose shape is the soft iron.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "base/sentence.h"

namespace tessera::calibrate {

/// A horizontal field along the compass chip's axes, µT.
struct FieldPoint {
  double x = 0.0;
  double y = 0.0;
};

/// corrected = matrix * (measured - offset), as the vehicle's settings say it. Offset in µT.
struct CompassCorrection {
  double offsetX = 0.0;
  double offsetY = 0.0;
  double xx = 1.0;
  double xy = 0.0;
  double yx = 0.0;
  double yy = 1.0;
  [[nodiscard]] FieldPoint apply(FieldPoint measured) const;
};

struct FieldEllipse {
  FieldPoint centre;
  double longAxis = 0.0;  ///< half axes, µT
  double shortAxis = 0.0;
  double angle = 0.0;  ///< of the long axis, from x towards y, radians
  /// For drawing, all around.
  [[nodiscard]] std::vector<FieldPoint> outline(int points) const;
};

/// Direct least squares, which always gives an ellipse: R. Halir, J. Flusser, "Numerically stable direct least squares
/// fitting of ellipses", WSCG 1998, the stable form of A. Fitzgibbon, M. Pilu, R. B. Fisher, IEEE T-PAMI 21(5), 1999.
/// Nullopt for fewer than 6 points, or points on a line.
[[nodiscard]] std::optional<FieldEllipse> fitEllipse(std::span<const FieldPoint> points);

struct CompassFit {
  static constexpr std::size_t kSectors = 24;

  FieldEllipse ellipse;
  CompassCorrection correction;      ///< makes the ellipse a circle about zero; symmetric, as a turn is the mounting's
  double radius = 0.0;               ///< of that circle: the earth's horizontal field, µT
  double misfit = 0.0;               ///< RMS distance of the corrected points from the circle, as a share of its radius
  std::array<bool, kSectors> met{};  ///< corrected directions in which there is a point, from -x counter-clockwise

  [[nodiscard]] int missing() const;
  /// What keeps it from being used, as a complete sentence; nullopt: nothing.
  [[nodiscard]] std::optional<Sentence> objection() const;
};
[[nodiscard]] std::optional<CompassFit> fitCompass(std::span<const FieldPoint> points);

/// How far the directions of two corrections lie apart at worst, radians.
[[nodiscard]] double largestTurn(const CompassCorrection& a, const CompassCorrection& b,
                                 std::span<const FieldPoint> points);

}  // namespace tessera::calibrate
