// Asks a vehicle one thing after the other, each when the one before is answered.
#pragma once

#include <QObject>
#include <QTimer>
#include <vector>

#include "ui/base/fleet_link.h"

namespace tessera::ui {

class AskSeries : public QObject {
  Q_OBJECT
public:
  explicit AskSeries(FleetLink& link, QObject* parent = nullptr);

  /// Begins anew; what was under way is forgotten.
  void start(VehicleId vehicle, std::vector<wire::Request> requests);
  void stop();
  [[nodiscard]] bool isRunning() const { return at_ < requests_.size(); }

Q_SIGNALS:
  /// index: of the request. The answer has a value.
  void answered(std::size_t index, const tessera::supervisor::AskAnswer& answer);
  void finished();
  /// No answer, or the order was not taken. The series is over. sentence: complete.
  void failed(const QString& sentence);

private:
  void ask();
  void hear(const std::vector<supervisor::Event>& events);
  void fail(const QString& sentence);

  FleetLink& link_;
  VehicleId vehicle_;
  std::vector<wire::Request> requests_;
  std::size_t at_ = 0;
  QTimer patience_;
};

}  // namespace tessera::ui
