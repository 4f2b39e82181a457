// A program as a person or a script starts it: words in; exit code, results and complaints out. It ends with its
// holder.
#pragma once

#include <QProcess>
#include <string>
#include <vector>

namespace tessera::system_test {

/// How long anything may take that does happen; a test that waits for it fails after that. Only for machines that hang.
inline constexpr int kPatienceMs = 60'000;

class Program {
public:
  Program(const std::string& path, const std::vector<std::string>& words);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// Waits for the end. The exit code; -1: it did not end, or not by itself.
  int exitCode();
  void signal(int which) const;
  [[nodiscard]] qint64 id() const { return process_.processId(); }
  [[nodiscard]] bool running() const { return process_.state() == QProcess::Running; }

  /// One line for its standard input.
  void say(const std::string& line);
  /// The next line of its standard output without its end; empty when it ended without one.
  std::string line();
  /// Waits until the text stands somewhere in its standard error. False: it ended or lost patience before.
  bool complains(const std::string& text);

  /// What has not been taken by line(); whole after exitCode().
  [[nodiscard]] const std::string& output() const { return output_; }
  [[nodiscard]] const std::string& errors() const { return errors_; }

private:
  void drain();

  QProcess process_;
  std::string output_;
  std::string errors_;
};

}  // namespace tessera::system_test
