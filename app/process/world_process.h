// A simulated world as a process of its own: the supervisor knows no more of it than a serial port.
#pragma once

#include <QObject>
#include <QProcess>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"

namespace tessera::process {

class WorldProcess : public QObject {
  Q_OBJECT
public:
  /// Another program than the tessera-world that stands beside this one: for tests.
  explicit WorldProcess(QString program = {}) : program_{std::move(program)} {}
  /// Asks the world to end and waits for it, at most some 15 s.
  ~WorldProcess() override;

  /// Starts the tessera-world that stands beside this program; ready() or died() follows. `arguments`: see
  /// world::worldArguments.
  void begin(const std::vector<std::string>& arguments);
  /// The same, and waits until its port is there. Error: it could not be started or ended before; the sentence repeats
  /// what it said.
  [[nodiscard]] Result<void> start(const std::vector<std::string>& arguments);

  /// Empty until it is ready.
  [[nodiscard]] const std::string& port() const { return port_; }
  /// One line for the world's standard input, see `tessera-world --help`.
  void command(const std::string& line);
  /// Asks it to end and waits until it has; kills it when it does not.
  void stop();

Q_SIGNALS:
  void ready(const QString& port);
  /// It could not be started, or ended although nobody asked it to; once.
  void died(const QString& sentence);
  /// Its answer to a command.
  void answered(const QString& line);
  /// A line of complaint while it runs: that the machine does not keep up, that a vehicle has ended.
  void complained(const QString& line);

private:
  void takeOutput();
  void fail(const QString& sentence);
  void takeComplaints();
  [[nodiscard]] QString complaint();

  QString program_;
  QProcess process_;
  std::string port_;
  QString failure_;
  QString said_;  ///< the last of its complaints
  bool stopping_ = false;
};

}  // namespace tessera::process
