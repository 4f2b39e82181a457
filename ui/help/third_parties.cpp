#include "ui/help/third_parties.h"

#include <polyclipping/clipper.hpp>

namespace tessera::ui {

QString ThirdParties::programVersion() { return QStringLiteral(TESSERA_VERSION); }

std::vector<ThirdParty> ThirdParties::all(const QString& sqliteVersion) {
  return {
      {"Qt", tr("%1 (built with %2)").arg(QLatin1String{qVersion()}, QStringLiteral(QT_VERSION_STR)), "LGPL-3.0",
       tr("window, ports, database access")},
      {"QCustomPlot", QStringLiteral(TESSERA_QCUSTOMPLOT_VERSION), "GPL-3.0", tr("charts")},
      {"SQLite", sqliteVersion, tr("public domain"), tr("sites and journal")},
      {"Eigen", QStringLiteral(TESSERA_EIGEN_VERSION), "MPL-2.0", tr("matrices")},
      {"JSON for Modern C++", QStringLiteral(TESSERA_JSON_VERSION), "MIT", tr("site files")},
      {"tl::expected", QStringLiteral(TESSERA_EXPECTED_VERSION), "CC0-1.0", tr("results or errors")},
      {"Clipper", QStringLiteral(CLIPPER_VERSION), "BSL-1.0", tr("areas of zones and tiles")},
      {"CLI11", QStringLiteral(TESSERA_CLI11_VERSION), "BSD-3-Clause", tr("command lines")},
  };
}

}  // namespace tessera::ui
