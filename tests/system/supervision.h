// The supervisor as the desktop runs it: on its thread, with Qt's serial port, and the events that it told so far.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host/supervisor_thread.h"

namespace tessera::system_test {

class Supervision {
public:
  /// Begins at once. The site's file must be right.
  Supervision(const std::string& site, const std::string& port);
  [[nodiscard]] static std::shared_ptr<const floor::SiteMap> mapOf(const std::string& site);

  /// Waits for a condition. False: patience ran out.
  bool until(const std::function<bool()>& condition);
  void post(supervisor::Order order) { thread_->post(std::move(order)); }
  /// Orders the site's first route for its first vehicle at this speed once it is connected, and waits until it has
  /// come `far` along it.
  bool drive(MetresPerSecond speed, Metres far);

  /// The first vehicle's.
  [[nodiscard]] supervisor::VehicleView view();
  [[nodiscard]] bool connected();
  [[nodiscard]] supervisor::PortState port();
  [[nodiscard]] int told(supervisor::EventKind kind, bool over = false) const;
  /// Waits for an event's sentence; told ones count. False: none came.
  bool hears(supervisor::EventKind kind, bool over = false);
  /// All sentences, a line each.
  [[nodiscard]] std::string sentences() const;

private:
  std::shared_ptr<const floor::SiteMap> map_;
  std::unique_ptr<host::SupervisorThread> thread_;
  std::vector<supervisor::Event> events_;
};

}  // namespace tessera::system_test
