// The calibration under way: records how the vehicle drives and what it reads, estimates anew from time to time, and
// enters what was found into the site.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <optional>

#include "calibrate/reader_calibration.h"
#include "supervisor/locating_view.h"
#include "ui/base/fleet_link.h"
#include "ui/base/site_document.h"

namespace tessera::ui {

class Calibration : public QObject {
  Q_OBJECT
public:
  /// Both must outlive it.
  Calibration(FleetLink& fleet, SiteDocument& document);

  [[nodiscard]] bool isRecording() const { return recording_; }
  /// Of this vehicle; another one than before begins anew. The supervision watches it from now on.
  void start(VehicleId vehicle);
  /// What was recorded stays.
  void stop();
  void clear();

  [[nodiscard]] std::optional<VehicleId> vehicle() const { return vehicle_; }
  [[nodiscard]] const calibrate::DriveRecord& drive() const { return drive_; }
  /// Of the last estimate; nullptr: there is none. problem() then says why, once something was recorded.
  [[nodiscard]] const calibrate::Calibration* result() const { return result_ ? &*result_ : nullptr; }
  [[nodiscard]] const Sentence& problem() const { return problem_; }
  /// As it stands in the site; nullptr: no longer there.
  [[nodiscard]] const floor::VehicleSetup* setup() const;
  /// What was found is known well enough to be entered.
  [[nodiscard]] bool isReady() const;
  [[nodiscard]] bool areWheelsReady() const;
  /// Readers that the drive tells of, and the wheels if they are to be: as one step of the site. Of what is not ready,
  /// nothing.
  Result<void> accept(bool wheels);
  /// A route for the drive, as one step of the site; its name. Error: no floor with room for it.
  Result<QString> drawFigure();

Q_SIGNALS:
  void changed();

private:
  void take();
  void askToWatch(const supervisor::Snapshot& snapshot);
  void estimate();

  FleetLink& fleet_;
  SiteDocument& document_;
  bool recording_ = false;
  std::optional<VehicleId> vehicle_;
  std::optional<floor::VehicleSetup> against_;  ///< with which it was recorded
  calibrate::DriveRecord drive_;
  std::optional<Seconds> lastRead_;
  std::optional<calibrate::Calibration> result_;
  Sentence problem_;
  QElapsedTimer asked_;
  QTimer soon_;
};

}  // namespace tessera::ui
