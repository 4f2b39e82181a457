// The parameters of a radio module beside those that the site asks for, line by line, in words.
#pragma once

#include <QCoreApplication>
#include <QString>
#include <optional>
#include <vector>

#include "floor/site.h"
#include "link/e32_parameters.h"

namespace tessera::ui {

struct RadioRow {
  QString name;
  QString module;        ///< empty: not read yet
  QString site;          ///< empty: the site leaves it open
  bool differs = false;  ///< both are known, and vehicles cannot be heard like this
};

class RadioRows {
  Q_DECLARE_TR_FUNCTIONS(tessera::ui::RadioRows)
public:
  /// What the site's vehicles need. `power`: 0 to 3, as E32Parameters::power; no vehicle minds it.
  [[nodiscard]] static link::E32Parameters wanted(const floor::RadioSetup& site, int power);
  [[nodiscard]] static std::vector<RadioRow> compare(const std::optional<link::E32Parameters>& module,
                                                     const link::E32Parameters& site);
  /// "20 dBm (100 mW)"
  [[nodiscard]] static QString powerText(int power);
};

}  // namespace tessera::ui
