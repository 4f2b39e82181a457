// Qt wants a private folder for run-time files and complains where a bare system (a container, a build machine) gives
// it none.
#pragma once

namespace tessera::process {

/// Before the QApplication is made. Changes nothing where XDG_RUNTIME_DIR is set, or where the system has no such
/// thing.
void provideRuntimeFolder();

}  // namespace tessera::process
