// `tessera-cli site convert`: sites from and to other formats.
#pragma once

#include "app/cli/command.h"

namespace tessera::cli {

void addSiteConvert(CLI::App& site, Run& run);

}  // namespace tessera::cli
