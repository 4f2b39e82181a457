// What to do about a radio over which too little is heard: from what the host's module says of itself and what comes
// out of it, to sentences in the order in which to try them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/sentence.h"
#include "base/units.h"
#include "link/e32_parameters.h"

namespace tessera::link {

struct RadioFindings {
  E32Parameters site;                   ///< what the site asks of every module
  std::optional<E32Parameters> module;  ///< what the host's holds; nullopt: not read yet
  Seconds listened;                     ///< since the port was opened for the vehicles; 0: not listened at all
  std::optional<Seconds> lastHeard;     ///< how long ago any vehicle of the site was heard; nullopt: never
  std::uint32_t damaged = 0;            ///< since then: bytes that are no frames, and frames with a wrong checksum
  std::uint32_t foreign = 0;            ///< since then: whole frames of vehicles that the site does not have
  bool wrongKey = false;                ///< a vehicle answers with another key than the site's

  /// The module was set anew and holds this now: what was heard before says nothing any more.
  void moduleChanged(const E32Parameters& now);
};

/// Empty: nothing is wrong as far as can be told. Where the module differs from the site, a sentence for each
/// parameter that keeps host and vehicles from hearing each other; then what its silence or noise means.
[[nodiscard]] std::vector<Sentence> radioAdvice(const RadioFindings& findings);

/// Only the part about the module: how it differs from what the site asks. The power does not count.
[[nodiscard]] std::vector<Sentence> differencesFromSite(const E32Parameters& module, const E32Parameters& site);

}  // namespace tessera::link
