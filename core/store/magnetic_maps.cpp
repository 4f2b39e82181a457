#include "store/magnetic_maps.h"

#include "locate/magnetic_file.h"
#include "store/transaction.h"

namespace tessera::store {

Result<void> MagneticMaps::save(const std::string& key, bool simulated, const locate::MagneticMap& map,
                                std::int64_t utcMs) {
  Transaction writing{database_, Transaction::Kind::Write};
  writing.run(QStringLiteral("DELETE FROM magnetic_map WHERE key=? AND simulated=?"), {toText(key), simulated ? 1 : 0});
  if (!map.empty()) {
    const auto bytes = locate::bytesOf(map);
    const QByteArray blob{reinterpret_cast<const char*>(bytes.data()), static_cast<qsizetype>(bytes.size())};
    writing.run(QStringLiteral("INSERT INTO magnetic_map(key, simulated, saved_ms, nodes) VALUES(?, ?, ?, ?)"),
                {toText(key), simulated ? 1 : 0, static_cast<qint64>(utcMs), blob});
  }
  return writing.commit();
}

Result<std::shared_ptr<const locate::MagneticMap>> MagneticMaps::load(const std::string& key, bool simulated) const {
  Transaction reading{database_, Transaction::Kind::Read};
  Statement row{reading, QStringLiteral("SELECT nodes FROM magnetic_map WHERE key=? AND simulated=?")};
  row.run({toText(key), simulated ? 1 : 0});
  const bool there = row.next();
  if (reading.failed()) return tl::unexpected{*reading.error()};
  if (!there) return nullptr;
  const QByteArray blob = row.value(0).toByteArray();
  auto map = locate::magneticMapFrom(
      {reinterpret_cast<const std::uint8_t*>(blob.constData()), static_cast<std::size_t>(blob.size())});
  if (!map) return passOn(map);
  return std::make_shared<const locate::MagneticMap>(std::move(*map));
}

}  // namespace tessera::store
