// What tessera-cli's exit code tells a script.
#pragma once

namespace tessera::cli {

enum ExitCode : int {
  kDone = 0,          ///< did what was asked
  kNotFinished = 1,   ///< ran, but a vehicle is not at its route's end, the radio module differs from
                      ///< the site, a site has errors, or two sites differ
  kUsage = 2,         ///< the words of the call are wrong
  kBadInput = 3,      ///< a file cannot be read or contradicts itself
  kNoPort = 4,        ///< the port, the radio module's answer or the simulated world could not be had
  kCannotWrite = 5,   ///< a result could not be written
  kInterrupted = 130  ///< Ctrl-C; vehicles were stopped first
};

inline constexpr const char* kExitCodeHelp =
    "Exit codes: 0 done; 1 a vehicle did not reach its route's end, the radio module differs from the site, a site\n"
    "has errors, or two sites differ; 2 wrong call; 3 a file cannot be read or contradicts itself; 4 no port,\n"
    "no answer from the radio module or no simulated world; 5 a result could not be written; 130 interrupted.\n"
    "With --json a failure is told on standard output too, as {\"error\": sentence}; a wrong call may be told on\n"
    "standard error alone.";

}  // namespace tessera::cli
