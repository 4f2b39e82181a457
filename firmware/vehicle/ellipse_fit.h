// The ellipse that a compass draws while its vehicle turns on the spot, fitted to samples.
#pragma once

#include <optional>
#include <span>

#include "firmware/vehicle/compass.h"

namespace tessera::firmware {

struct EllipseFit {
  CompassCorrection correction;  ///< turns the ellipse into a circle about zero of radius `radius`; symmetric
  float radius = 0.0F;           ///< µT, geometric mean of the half axes
  float axisRatio = 1.0F;        ///< longer half axis over the shorter one
  float misfit = 0.0F;           ///< RMS distance of the corrected samples from the circle, as a share of its radius
};

/// Least squares over the conic's algebraic distance with the constraint A + C = 1, which does not favour any
/// direction: P. L. Rosin, "A note on the least squares fitting of ellipses", Pattern Recognition Letters 14 (1993)
/// 799–808. The matrix is the symmetric square root, as iron that is magnetised by the field acts symmetrically; a turn
/// in it could not be told from the mounting. Nullopt for fewer than 8 samples, or when they lie on no ellipse.
[[nodiscard]] std::optional<EllipseFit> fitEllipse(std::span<const Field> samples);

}  // namespace tessera::firmware
