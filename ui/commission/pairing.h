// Gives a vehicle its key, and one that is fresh from the factory its address: calls it, pairs, lets it take the
// address, and has the site follow each step, so that the key is never only on the vehicle.
#pragma once

#include <QObject>
#include <QTimer>

#include "ui/base/ask_series.h"
#include "ui/commission/commissioning.h"

namespace tessera::ui {

class Pairing : public QObject {
  Q_OBJECT
public:
  /// Vehicles that nobody has set up answer at this address.
  static constexpr VehicleId kFreshAddress{254};

  explicit Pairing(Commissioning& work, QObject* parent = nullptr);

  /// Gives the vehicle that is in contact a new key; when none is, calls one that is fresh from the factory.
  void start();
  /// The site then expects the draft again, or what the vehicle has taken by now.
  void cancel();
  /// The key that the vehicle may have without the site knowing it, in a sentence; empty: there is none.
  [[nodiscard]] QString doubt() const;
  [[nodiscard]] bool isRunning() const { return phase_ != Phase::Idle; }

Q_SIGNALS:
  /// One sentence on what is being done.
  void progressed(const QString& sentence);
  void done();
  void failed(const QString& sentence);

private:
  enum class Phase { Idle, Calling, Keying, CallingAgain, Addressing };

  void look();
  void hear(const std::vector<supervisor::Event>& events);
  void askForKey();
  void takeKey();
  void askForAddress();
  void finish();
  void fail(const QString& sentence);
  void await(Phase phase, const QString& sentence);

  Commissioning& work_;
  AskSeries series_;
  Phase phase_ = Phase::Idle;
  wire::Key fresh_{};
  Seconds asked_;        ///< what happened until then belongs to an earlier pairing
  bool unsure_ = false;  ///< it was offered and neither taken nor refused for certain
  QTimer patience_;
};

}  // namespace tessera::ui
