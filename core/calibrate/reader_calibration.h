// Where the readers sit on a vehicle and how much larger its wheels are than entered, from a drive over registered
// tags: least squares over the way driven and these parameters together (simultaneous calibration and localisation: R.
// Kümmerle, G. Grisetti, W. Burgard, "Simultaneous calibration, localization, and mapping", IROS 2011; what of it can
// be told from odometry and exteroceptive reads: A. Censi, A. Franchi, L. Marchionni, G. Oriolo, "Simultaneous
// calibration of odometry and sensor parameters for mobile robots", IEEE T-RO 29(2), 2013). Gauss-Newton, with P. J.
// Huber's weights (Ann. Math. Stat. 35, 1964) against reads that belong elsewhere.
#pragma once

#include <vector>

#include "base/result.h"
#include "calibrate/drive_record.h"
#include "floor/site.h"
#include "locate/innovation.h"

namespace tessera::calibrate {

struct CalibratedReader {
  Offset mount;
  Metres sigmaAhead;  ///< standard deviations
  Metres sigmaAside;
  int reads = 0;
};

struct Calibration {
  std::vector<CalibratedReader> readers;  ///< in the order of the setup
  double wheelScale = 1.0;                ///< true way over the odometer's
  double wheelSigma = 0.0;
  int reads = 0;        ///< used
  int outliers = 0;     ///< of these, reads that fit nothing; they hardly count
  double unrest = 0.0;  ///< m per root of a metre: by so much the odometer trembles, as the drive tells
};

struct CalibrationOptions {
  Seconds readLag = locate::kReadLag;
  // What is known beforehand: the setup's values, within these deviations.
  double mountSigma = 0.05;  ///< m
  double scaleSigma = 0.05;
  double biasSigma = 0.15;  ///< rad, of the reported heading
};

inline constexpr int kFewestCalibrationReads = 20;
/// A reader's offset that is known no better than this was not told by the drive: it never turned, or hardly read.
inline constexpr Metres kUndetermined{0.02};
/// Known better than this, an offset is worth entering. Readers share the way driven: early in a drive all of them are
/// off together, so that they agree says nothing.
inline constexpr Metres kWellKnown{0.008};
inline constexpr double kWellKnownScale = 0.01;
/// Half turns before a drive tells offsets apart from the way.
inline constexpr int kFewestHalfTurns = 3;

/// What a drive still lacks before its offsets are worth entering.
enum class Lacking { Nothing, Turns, Drive };
[[nodiscard]] Lacking lacking(const DriveRecord& drive, const Calibration& found);
/// The drive tells of this reader's offset.
[[nodiscard]] bool isDetermined(const CalibratedReader& reader);

/// setup: as it stands in the site. Error: too few reads, or a drive from which nothing can be told.
[[nodiscard]] Result<Calibration> calibrateReaders(const DriveRecord& drive, const floor::VehicleSetup& setup,
                                                   const CalibrationOptions& options = {});

}  // namespace tessera::calibrate
