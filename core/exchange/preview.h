// What an import would do, before it is done.
#pragma once

#include "base/result.h"
#include "sitediff/difference.h"

namespace tessera::exchange {

struct Preview {
  floor::Site site;  ///< as it would become
  sitediff::Changes changes;
  std::vector<Sentence> notes;  ///< what the file holds and the site cannot, and what was assumed
};

}  // namespace tessera::exchange
