#include "app/tessera/offered_keys.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>
#include <QStandardPaths>
#include <algorithm>

namespace tessera::desktop {
namespace {

bool hasKey(const floor::Site& site, const wire::Key& key) {
  return std::any_of(site.vehicles.begin(), site.vehicles.end(), [&](const auto& v) { return v.key == key; });
}

}  // namespace

OfferedKeys::OfferedKeys()
    : path_{QDir{QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)}.filePath(
          QStringLiteral("offered-keys.json"))} {
  QFile file{path_};
  if (!file.open(QIODevice::ReadOnly)) return;
  const QJsonObject entries = QJsonDocument::fromJson(file.readAll()).object();
  for (auto entry = entries.begin(); entry != entries.end(); ++entry) {
    const QByteArray bytes = QByteArray::fromHex(entry.value().toString().toLatin1());
    const uint address = entry.key().toUInt();
    wire::Key key{};
    if (static_cast<std::size_t>(bytes.size()) != key.size() || address < 1 || address > 254) continue;
    std::copy(bytes.begin(), bytes.end(), key.begin());
    keys_[VehicleId{static_cast<std::uint8_t>(address)}] = key;
  }
}

Result<void> OfferedKeys::add(VehicleId vehicle, const wire::Key& key) {
  keys_[vehicle] = key;
  return write();
}

std::map<VehicleId, wire::Key> OfferedKeys::unknownTo(const floor::Site& site) const {
  std::map<VehicleId, wire::Key> found;
  for (const floor::VehicleSetup& vehicle : site.vehicles) {
    const auto offered = keys_.find(vehicle.id);
    if (offered != keys_.end() && !hasKey(site, offered->second)) found.insert(*offered);
  }
  return found;
}

void OfferedKeys::forget(const floor::Site& site) {
  if (std::erase_if(keys_, [&](const auto& entry) { return hasKey(site, entry.second); }) > 0) (void)write();
}

Result<void> OfferedKeys::write() const {
  QJsonObject entries;
  for (const auto& [vehicle, key] : keys_) {
    const QByteArray bytes{reinterpret_cast<const char*>(key.data()), static_cast<qsizetype>(key.size())};
    entries.insert(QString::number(vehicle.value), QString::fromLatin1(bytes.toHex()));
  }
  QDir{}.mkpath(QFileInfo{path_}.path());
  QSaveFile file{path_};
  const QByteArray text = QJsonDocument{entries}.toJson();
  // Nobody else's to read, from the first byte on.
  if (file.open(QIODevice::WriteOnly) && file.setPermissions(QFile::ReadOwner | QFile::WriteOwner) &&
      file.write(text) == text.size() && file.commit())
    return {};
  return failure(phrase("Core", "The vehicle's new key could not be kept in %1, so it was not sent: %2.")
                     .with(path_.toStdString(), file.errorString().toStdString()));
}

}  // namespace tessera::desktop
