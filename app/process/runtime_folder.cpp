#include "app/process/runtime_folder.h"

#include <QtGlobal>

#ifdef Q_OS_UNIX
#include <sys/stat.h>
#include <unistd.h>
#endif
#include <QDir>
#include <QFileInfo>

namespace tessera::process {

void provideRuntimeFolder() {
#ifdef Q_OS_UNIX
  if (!qEnvironmentVariableIsEmpty("XDG_RUNTIME_DIR")) return;
  const QString folder = QDir::tempPath() + QStringLiteral("/tessera-run-%1").arg(getuid());
  const bool made = mkdir(qPrintable(folder), 0700) == 0;
  // One of the same name that somebody else made is not private.
  if (const QFileInfo there{folder}; made || (there.isDir() && !there.isSymLink() && there.ownerId() == getuid()))
    qputenv("XDG_RUNTIME_DIR", folder.toLocal8Bit());
#endif
}

}  // namespace tessera::process
