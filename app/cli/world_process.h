// A simulated world as a process of its own: the supervisor knows no more of it than a serial port.
#pragma once

#include <QObject>
#include <QProcess>
#include <string>
#include <vector>

#include "base/result.h"

namespace tessera::cli {

class WorldProcess : public QObject {
  Q_OBJECT
public:
  /// Starts the tessera-world that stands beside this program and waits until its port is there.
  /// Error: it could not be started or ended before; the sentence repeats what it said.
  [[nodiscard]] Result<void> start(const std::vector<std::string>& arguments);
  ~WorldProcess() override;

  [[nodiscard]] const std::string& port() const { return port_; }
  /// One line for the world's standard input, see `tessera-world --help`.
  void command(const std::string& line);
  /// Asks it to end and waits until it has; kills it when it does not.
  void stop();

Q_SIGNALS:
  /// It ended although nobody asked it to.
  void died(const QString& sentence);

private:
  [[nodiscard]] QString complaint();

  QProcess process_;
  std::string port_;
  bool stopping_ = false;
};

}  // namespace tessera::cli
