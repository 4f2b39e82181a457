// `tessera-cli site revisions`: what the window kept of a site at each saving.
#pragma once

#include "app/cli/command.h"

namespace tessera::cli {

void addSiteRevisions(CLI::App& site, Run& run);

}  // namespace tessera::cli
