#include "app/cli/output.h"

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/cli/exit_codes.h"

namespace tessera::cli {

int complain(const std::string& sentence, int code) {
  std::fprintf(stderr, "tessera-cli: %s\n", sentence.c_str());
  return code;
}

int fail(bool json, const std::string& sentence, int code) {
  if (json) say(nlohmann::json{{"error", sentence}}.dump(2));
  return complain(sentence, code);
}

int failToWrite(bool json, const std::string& sentence, const std::string& file, bool force) {
  std::error_code error;
  const bool inTheWay = !force && std::filesystem::is_regular_file(file, error);
  return fail(json, sentence + (inTheWay ? " See --force." : ""), kCannotWrite);
}

void say(const std::string& sentence) { std::printf("%s\n", sentence.c_str()); }

std::string lineOf(const supervisor::Event& event, Seconds since) {
  char time[32];
  std::snprintf(time, sizeof time, "%7.1f s  ", (event.time - since).value());
  const std::string severity{supervisor::nameOf(event.severity)};
  return time + severity + std::string(severity.size() < 9 ? 9 - severity.size() : 1, ' ') + event.sentence.english();
}

ProgressLine::ProgressLine(bool quiet) : quiet_{quiet}, terminal_{isatty(STDERR_FILENO) == 1} {}

ProgressLine::~ProgressLine() {
  if (open_) std::fputc('\n', stderr);
}

void ProgressLine::show(double share, const std::string& text) {
  if (quiet_) return;
  const int percent = static_cast<int>(share * 100.0);
  if (terminal_) {
    std::fprintf(stderr, "\r\033[K[%3d %%] %.150s", percent, text.c_str());
    std::fflush(stderr);
    open_ = true;
  } else if (percent / 10 != lastTenth_) {
    lastTenth_ = percent / 10;
    std::fprintf(stderr, "[%3d %%] %s\n", percent, text.c_str());
  }
}

void ProgressLine::note(const std::string& text) {
  if (quiet_) return;
  wipe();
  std::fprintf(stderr, "%s\n", text.c_str());
}

void ProgressLine::wipe() {
  if (!open_) return;
  std::fputs("\r\033[K", stderr);
  open_ = false;
}

}  // namespace tessera::cli
