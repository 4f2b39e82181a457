#include "app/tessera/site_lock.h"

#include <QCryptographicHash>
#include <QDir>
#include <QStandardPaths>
#include <QString>

namespace tessera::desktop {
namespace {

// Not beside the site: its folder may be read only, and files that nobody asked for do not belong there.
std::unique_ptr<QLockFile> lockFor(const std::string& key) {
  const QDir folder{QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/open")};
  folder.mkpath(QStringLiteral("."));
  const QByteArray name = QCryptographicHash::hash(QByteArray::fromStdString(key), QCryptographicHash::Sha256).toHex();
  auto lock = std::make_unique<QLockFile>(folder.filePath(QString::fromLatin1(name.left(16))));
  lock->setStaleLockTime(0);  // a site may be open for months
  return lock;
}

}  // namespace

void SiteLock::take(const std::string& key) {
  if (lock_ && key == key_) return;
  key_ = key;
  lock_ = lockFor(key);
  if (!lock_->tryLock()) lock_.reset();
}

std::optional<qint64> SiteLock::holderOf(const std::string& key) const {
  if (lock_ && key == key_) return std::nullopt;
  const auto lock = lockFor(key);
  qint64 process = 0;
  QString host;
  QString program;
  if (lock->tryLock() || lock->error() != QLockFile::LockFailedError || !lock->getLockInfo(&process, &host, &program))
    return std::nullopt;
  return process;
}

}  // namespace tessera::desktop
