#include "ui/connect/radio_rows.h"

#include <QLocale>
#include <algorithm>
#include <array>

#include "floor/site_names.h"

namespace tessera::ui {
namespace {

constexpr std::array<int, 4> kDecibels{20, 17, 14, 10};
constexpr std::array<int, 4> kMilliwatts{100, 50, 25, 10};

QString rateInBits(int bitsPerSecond) { return QLocale{}.toString(bitsPerSecond); }

}  // namespace

link::E32Parameters RadioRows::wanted(const floor::RadioSetup& site, int power) {
  link::E32Parameters p;
  p.channel = site.channel;
  for (std::size_t i = 0; i < floor::kAirRates.size(); ++i)
    if (floor::kAirRates[i] <= site.airRate) p.airRate = static_cast<int>(i);
  p.baud = site.baud;
  p.power = std::clamp(power, 0, 3);
  return p;
}

QString RadioRows::powerText(int power) {
  const auto i = static_cast<std::size_t>(std::clamp(power, 0, 3));
  return tr("%1 dBm (%2 mW)").arg(QLocale{}.toString(kDecibels[i]), QLocale{}.toString(kMilliwatts[i]));
}

std::vector<RadioRow> RadioRows::compare(const std::optional<link::E32Parameters>& module,
                                         const link::E32Parameters& site) {
  const auto airRate = [](const link::E32Parameters& p) {
    return tr("%1 bit/s").arg(rateInBits(floor::kAirRates[static_cast<std::size_t>(std::clamp(p.airRate, 0, 5))]));
  };
  const auto channel = [](const link::E32Parameters& p) {
    return tr("%1 (%2 MHz)").arg(QLocale{}.toString(p.channel), QLocale{}.toString(410 + p.channel));
  };
  const auto address = [](const link::E32Parameters& p) {
    return QStringLiteral("%1").arg(p.address, 4, 16, QLatin1Char('0')).toUpper();
  };
  const auto baud = [](const link::E32Parameters& p) { return tr("%1 bit/s").arg(rateInBits(p.baud)); };
  const auto way = [](const link::E32Parameters& p) { return p.fixedTransmission ? tr("fixed") : tr("transparent"); };
  const auto correction = [](const link::E32Parameters& p) { return p.forwardErrorCorrection ? tr("on") : tr("off"); };
  const auto power = [](const link::E32Parameters& p) { return powerText(p.power); };
  const auto format = [](const link::E32Parameters& p) {
    using Parity = link::E32Parameters::Parity;
    return p.parity == Parity::None  ? QStringLiteral("8N1")
           : p.parity == Parity::Odd ? QStringLiteral("8O1")
                                     : QStringLiteral("8E1");
  };
  const auto outputs = [](const link::E32Parameters& p) { return p.pushPull ? tr("push-pull") : tr("open collector"); };

  std::vector<RadioRow> rows;
  const auto add = [&](const QString& name, auto text, bool matters) {
    RadioRow row{name, module ? text(*module) : QString{}, text(site), false};
    row.differs = matters && module && row.module != row.site;
    rows.push_back(row);
  };
  add(tr("Channel"), channel, true);
  add(tr("Air rate"), airRate, true);
  add(tr("Address (hexadecimal)"), address, true);
  add(tr("Transmission"), way, true);
  add(tr("Error correction"), correction, true);
  add(tr("Port's baud rate"), baud, true);
  add(tr("Port's format"), format, true);
  add(tr("Outputs"), outputs, true);
  add(tr("Transmit power"), power, false);
  return rows;
}

}  // namespace tessera::ui
