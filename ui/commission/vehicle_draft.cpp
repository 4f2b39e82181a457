#include "ui/commission/vehicle_draft.h"

#include <QRandomGenerator>
#include <algorithm>
#include <array>

namespace tessera::ui {
namespace {

floor::VehicleSetup usualVehicle(VehicleExtent extent, double track, double wheel, double maxSpeed, int readers) {
  floor::VehicleSetup v;
  v.footprint = VehicleDraft::outlineOf(extent);
  v.track = Metres{track};
  v.wheelDiameter = Metres{wheel};
  v.maxSpeed = MetresPerSecond{maxSpeed};
  v.readers = VehicleDraft::readerRow(readers, 0.75 * extent.front, 0.1 * (readers - 1) * Metres{1.0});
  return v;
}

}  // namespace

VehicleExtent VehicleDraft::extentOf(const std::vector<Point>& footprint) {
  VehicleExtent e;
  for (const Point& p : footprint) {
    e.front = std::max(e.front, p.x);
    e.rear = std::max(e.rear, -p.x);
    e.side = std::max(e.side, abs(p.y - Metres{}));
  }
  return e;
}

std::vector<Point> VehicleDraft::outlineOf(const VehicleExtent& e) {
  return {{-e.rear, -e.side}, {e.front, -e.side}, {e.front, e.side}, {-e.rear, e.side}};
}

std::vector<Offset> VehicleDraft::readerRow(int count, Metres ahead, Metres width) {
  std::vector<Offset> row;
  for (int i = 0; i < count; ++i)
    row.push_back({ahead, count == 1 ? Metres{} : 0.5 * width - (static_cast<double>(i) / (count - 1)) * width});
  return row;
}

std::vector<VehiclePreset> VehicleDraft::presets(const floor::Site& site) {
  using namespace literals;
  std::vector<VehiclePreset> list{
      {tr("Small: 0.40 m × 0.36 m, 3 readers"), usualVehicle({0.20_m, 0.20_m, 0.18_m}, 0.30, 0.10, 0.5, 3)},
      {tr("Medium: 0.70 m × 0.50 m, 4 readers"), usualVehicle({0.35_m, 0.35_m, 0.25_m}, 0.42, 0.15, 0.8, 4)},
      {tr("Large: 1.10 m × 0.80 m, 5 readers"), usualVehicle({0.55_m, 0.55_m, 0.40_m}, 0.68, 0.20, 1.0, 5)}};
  for (const floor::VehicleSetup& v : site.vehicles)
    list.push_back({tr("Like %1").arg(QString::fromStdString(v.name)), v});
  return list;
}

std::optional<VehicleId> VehicleDraft::freeAddress(const floor::Site& site) {
  std::array<bool, 256> taken{};
  for (const floor::VehicleSetup& v : site.vehicles) taken[v.id.value] = true;
  for (std::uint8_t a = 1; a <= 254; ++a)
    if (!taken[a]) return VehicleId{a};
  return std::nullopt;
}

QString VehicleDraft::freeName(const floor::Site& site, VehicleId address) {
  for (int number = address.value;; ++number) {
    const QString name = tr("AGV %1").arg(number);
    const bool taken = std::any_of(site.vehicles.begin(), site.vehicles.end(),
                                   [&](const auto& v) { return v.name == name.toStdString(); });
    if (!taken) return name;
  }
}

QString VehicleDraft::complaint(const floor::Site& site, const floor::VehicleSetup& draft,
                                std::optional<VehicleId> except) {
  const QString name = QString::fromStdString(draft.name);
  if (name.trimmed().isEmpty()) return tr("Give the vehicle a name.");
  if (draft.id.value == 0 || draft.id.value > 254) return tr("An address is a number from 1 to 254.");
  for (const floor::VehicleSetup& v : site.vehicles) {
    if (v.id == except) continue;
    if (v.id == draft.id)
      return tr("%1 has the address %2 already. Choose another one.")
          .arg(QString::fromStdString(v.name))
          .arg(draft.id.value);
    if (v.name == draft.name) return tr("There is a vehicle named %1 already. Choose another name.").arg(name);
  }
  return {};
}

wire::Key VehicleDraft::randomKey() {
  wire::Key key;
  std::array<quint32, 4> words{};
  QRandomGenerator::system()->fillRange(words.data(), static_cast<qsizetype>(words.size()));
  for (std::size_t i = 0; i < key.size(); ++i) key[i] = static_cast<std::uint8_t>(words[i / 4] >> (8 * (i % 4)));
  return key;
}

std::optional<wire::Key> VehicleDraft::keyFromText(const QString& text) {
  QByteArray digits;
  for (const QChar c : text) {
    if (c.isSpace() || c == QLatin1Char('-') || c == QLatin1Char(':')) continue;
    const bool hex = (c >= QLatin1Char('0') && c <= QLatin1Char('9')) ||
                     (c.toUpper() >= QLatin1Char('A') && c.toUpper() <= QLatin1Char('F'));
    if (!hex) return std::nullopt;
    digits += c.toLatin1();
  }
  wire::Key key;
  if (digits.size() != static_cast<qsizetype>(2 * key.size())) return std::nullopt;
  const QByteArray bytes = QByteArray::fromHex(digits);
  std::copy(bytes.begin(), bytes.end(), key.begin());
  return key;
}

QString VehicleDraft::keyText(const wire::Key& key) {
  const QByteArray hex =
      QByteArray::fromRawData(reinterpret_cast<const char*>(key.data()), static_cast<qsizetype>(key.size()))
          .toHex()
          .toUpper();
  QString text;
  for (qsizetype i = 0; i < hex.size(); i += 4)
    text += (i == 0 ? QString{} : QStringLiteral(" ")) + QString::fromLatin1(hex.mid(i, 4));
  return text;
}

}  // namespace tessera::ui
