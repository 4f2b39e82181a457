// What the program is made of besides its own code, and under which licences.
#pragma once

#include <QCoreApplication>
#include <QString>
#include <vector>

namespace tessera::ui {

struct ThirdParty {
  QString name;
  QString version;  ///< empty: not known here
  QString licence;
  QString use;
};

class ThirdParties {
  Q_DECLARE_TR_FUNCTIONS(tessera::ui::ThirdParties)
public:
  [[nodiscard]] static std::vector<ThirdParty> all(const QString& sqliteVersion);
  /// "0.1.0"
  [[nodiscard]] static QString programVersion();
};

}  // namespace tessera::ui
