#include "system/program.h"

#include <signal.h>

#include <QDeadlineTimer>
#include <algorithm>

namespace tessera::system_test {

Program::Program(const std::string& path, const std::vector<std::string>& words) {
  QStringList arguments;
  for (const std::string& word : words) arguments << QString::fromStdString(word);
  process_.start(QString::fromStdString(path), arguments);
  process_.waitForStarted(kPatienceMs);
}

Program::~Program() {
  if (!running()) return;
  process_.kill();
  process_.waitForFinished(kPatienceMs);
}

void Program::drain() {
  output_ += process_.readAllStandardOutput().toStdString();
  errors_ += process_.readAllStandardError().toStdString();
}

int Program::exitCode() {
  if (running() && !process_.waitForFinished(kPatienceMs)) return -1;
  drain();
  return process_.exitStatus() == QProcess::NormalExit ? process_.exitCode() : -1;
}

void Program::signal(int which) const {
  if (running()) ::kill(static_cast<pid_t>(process_.processId()), which);
}

void Program::say(const std::string& line) {
  process_.write((line + "\n").c_str());
  process_.waitForBytesWritten(kPatienceMs);
}

std::string Program::line() {
  const QDeadlineTimer end{kPatienceMs};
  drain();
  while (output_.find('\n') == std::string::npos && running() && !end.hasExpired()) {
    process_.waitForReadyRead(100);
    drain();
  }
  const std::size_t at = std::min(output_.find('\n'), output_.size());
  std::string first = output_.substr(0, at);
  output_.erase(0, at + 1);
  return first;
}

bool Program::complains(const std::string& text) {
  const QDeadlineTimer end{kPatienceMs};
  drain();
  while (errors_.find(text) == std::string::npos && running() && !end.hasExpired()) {
    process_.setReadChannel(QProcess::StandardError);
    process_.waitForReadyRead(100);
    process_.setReadChannel(QProcess::StandardOutput);
    drain();
  }
  return errors_.find(text) != std::string::npos;
}

}  // namespace tessera::system_test
