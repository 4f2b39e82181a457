// Registering as steps of the document, light ones: there is one for each tag of a floor.
#pragma once

#include <QCoreApplication>
#include <QString>

#include "scan/walk.h"
#include "ui/base/site_document.h"

namespace tessera::ui {

class RegisterEdits {
  Q_DECLARE_TR_FUNCTIONS(RegisterEdits)
public:
  explicit RegisterEdits(SiteDocument& document) : document_{document} {}

  Result<void> put(const scan::PlaceName& place, const floor::TagUid& uid);
  /// What stood there before a registration that is taken back; empty: nothing.
  Result<void> takeBack(const scan::PlaceName& place, const floor::TagUid& before);
  /// No tag of the tile is registered any more.
  Result<void> clear(const QString& serial);

private:
  Result<void> set(const QString& step, const std::string& serial, std::vector<floor::TagUid> uids);
  [[nodiscard]] std::vector<floor::TagUid> with(const scan::PlaceName& place, const floor::TagUid& uid) const;

  SiteDocument& document_;
};

/// Nullptr: the site has no such tile.
[[nodiscard]] const floor::Tile* tileOf(const floor::Site& site, const std::string& serial);

}  // namespace tessera::ui
