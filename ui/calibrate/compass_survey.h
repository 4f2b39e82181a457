// The compass of one vehicle: has it turn on the spot, fetches what its compass measured in each direction while it
// turns, fits, and writes what was found into the vehicle, or what stood there before.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <array>
#include <map>
#include <optional>
#include <vector>

#include "calibrate/compass_fit.h"
#include "ui/base/ask_series.h"
#include "ui/base/notice.h"
#include "wire/parameters.h"

namespace tessera::ui {

class CompassSurvey : public QObject {
  Q_OBJECT
public:
  /// Offsets and matrix as the vehicle's settings count them, in the order of their parameters' numbers.
  using Values = std::array<std::int32_t, 6>;
  enum class Phase { Idle, Reading, Starting, Turning, Fetching, Writing, Verifying };

  /// It must outlive this.
  explicit CompassSurvey(FleetLink& fleet);

  /// Forgets the last turn, reads what the vehicle corrects by, and has it turn.
  void start(VehicleId vehicle);
  /// The vehicle stops turning; what was fetched stays. What is being written is written to its end.
  void stop();
  /// Enters what was found, or what stood in the vehicle before it was entered, and reads it back. Requires mayWrite(),
  /// mayRestore().
  void write();
  void restore();

  [[nodiscard]] Phase phase() const { return phase_; }
  [[nodiscard]] bool isBusy() const { return phase_ != Phase::Idle; }
  /// It is measured, not written to: may be stopped.
  [[nodiscard]] bool measures() const { return isBusy() && !writes(); }
  /// What corrects in the vehicle may be half old, half new until this has ended: nobody else knows the old values.
  [[nodiscard]] bool writes() const { return phase_ == Phase::Writing || phase_ == Phase::Verifying; }
  /// It moves, or is about to.
  [[nodiscard]] bool turns() const { return phase_ == Phase::Starting || phase_ == Phase::Turning; }
  [[nodiscard]] std::optional<VehicleId> vehicle() const { return vehicle_; }
  [[nodiscard]] const std::vector<calibrate::FieldPoint>& points() const { return points_; }
  /// Of a whole turn; nullopt: there is none.
  [[nodiscard]] const std::optional<calibrate::CompassFit>& fit() const { return fit_; }
  /// By what the vehicle corrects now; nullopt: not read yet.
  [[nodiscard]] std::optional<calibrate::CompassCorrection> present() const;
  /// true: what is in force is right by the last turn, and was written and kept if it was not before. false: since that
  /// turn something else was written, or not all of it, or it was not kept. nullopt: neither is known.
  [[nodiscard]] std::optional<bool> isRight() const { return right_; }
  [[nodiscard]] bool mayWrite() const;
  [[nodiscard]] bool mayRestore() const;
  /// The vehicle's program is too old for a survey, as the last start() showed; it can only calibrate by itself.
  [[nodiscard]] bool isTooOld() const { return tooOld_; }

  [[nodiscard]] Notice::Tone tone() const { return tone_; }
  /// What came of it, or how far it is; empty: nothing was begun.
  [[nodiscard]] QString message() const { return message_; }

Q_SIGNALS:
  void changed();

private:
  void hear(std::size_t index, const supervisor::AskAnswer& answer);
  void hearSample(const supervisor::AskAnswer& answer);
  void askForTurn();
  void askForSample();
  void look();
  void fetchRest();
  void judge();
  void put(const Values& values);
  void checkWritten();
  [[nodiscard]] Radians errorOfPresent() const;
  void end(Notice::Tone tone, const QString& message);
  [[nodiscard]] const supervisor::VehicleView* view() const;
  [[nodiscard]] std::vector<wire::Request> requests(wire::MessageType type, const Values& values) const;

  FleetLink& fleet_;
  AskSeries series_;
  Phase phase_ = Phase::Idle;
  std::optional<VehicleId> vehicle_;
  std::array<std::optional<calibrate::FieldPoint>, wire::kCompassSamples> samples_{};
  std::vector<calibrate::FieldPoint> points_;
  std::optional<calibrate::CompassFit> fit_;
  std::optional<Values> present_;
  Values wanted_{};
  std::map<VehicleId, Values> before_;  ///< what stood in vehicles before something was written into them
  std::optional<bool> right_;
  bool seenTurning_ = false;
  bool tooOld_ = false;
  QElapsedTimer sinceStart_;
  QTimer again_;  ///< a direction that the vehicle has not reached yet
  Notice::Tone tone_ = Notice::Tone::Info;
  QString message_;
};

}  // namespace tessera::ui
