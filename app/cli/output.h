// How tessera-cli speaks: results to standard output, progress and complaints to standard error, so that a pipe gets
// results alone.
#pragma once

#include <string>

#include "supervisor/event.h"

namespace tessera::cli {

/// A complaint in a sentence on standard error; returns `code` so that a command can end with it.
int complain(const std::string& sentence, int code);
/// The same of a command with --json, which has an answer on standard output whatever happens: {"error": sentence}.
int fail(bool json, const std::string& sentence, int code);
/// Of a file that was not written: what saveText says, with the way to replace it where that is what is in the way.
int failToWrite(bool json, const std::string& sentence, const std::string& file, bool force);
void say(const std::string& sentence);

/// "  12.3 s  warning  AGV 1 has been silent for 1.2 s."
[[nodiscard]] std::string lineOf(const supervisor::Event& event, Seconds since);

/// One line of progress that is written over on a terminal, and written now and then elsewhere.
class ProgressLine {
public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  /// share: 0 to 1.
  void show(double share, const std::string& text);
  /// A line of its own, above the progress.
  void note(const std::string& text);

private:
  void wipe();

  bool quiet_;
  bool terminal_;
  bool open_ = false;
  int lastTenth_ = -1;
};

}  // namespace tessera::cli
