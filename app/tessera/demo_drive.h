// A drive that was asked for on the command line: begun as soon as the vehicle answers, watched to its end.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <optional>

#include "base/units.h"
#include "supervisor/snapshot.h"

namespace tessera::desktop {

class MainWindow;

class DemoDrive : public QObject {
  Q_OBJECT
public:
  struct Plan {
    QString route;                ///< of the open site; empty: its first
    MetresPerSecond speed{0.12};  ///< above 0
    bool untilFinished = false;   ///< close the window at the route's end
    QString folder;               ///< for window.png, taken at the end; empty: none
    int limitS = 600;             ///< s; with untilFinished, a drive that takes longer has failed
  };
  DemoDrive(MainWindow& window, Plan plan);

Q_SIGNALS:
  /// With untilFinished; failure: empty, or a complete sentence.
  void ended(const QString& failure);

private:
  void look();
  void order(const supervisor::Snapshot& snapshot);
  void end(QString failure);

  MainWindow& window_;
  Plan plan_;
  QTimer limit_;
  std::optional<VehicleId> vehicle_;
  bool ended_ = false;
};

}  // namespace tessera::desktop
