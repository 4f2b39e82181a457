// Where vehicles truly are: only a simulated world knows, and it tells it to this view alone.
#pragma once

#include <QObject>

#include "base/ids.h"
#include "base/pose.h"

namespace tessera::ui {

struct TruthSample {
  VehicleId vehicle;
  Seconds at;  ///< on the snapshots' clock
  Pose pose;
};

class TruthSource : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;
  /// False: the vehicles are real, or nobody simulates just now.
  [[nodiscard]] virtual bool isThere() const = 0;
  /// told() follows, if the world has that vehicle.
  virtual void ask(VehicleId vehicle) = 0;

Q_SIGNALS:
  void told(const tessera::ui::TruthSample& sample);
};

}  // namespace tessera::ui
