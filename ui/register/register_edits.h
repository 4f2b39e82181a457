// Registering as steps of the document, light ones: there is one for each tag of a floor.
#pragma once

#include <QCoreApplication>
#include <QString>

#include "scan/registration.h"
#include "ui/base/site_document.h"

namespace tessera::ui {

class RegisterEdits {
  Q_DECLARE_TR_FUNCTIONS(RegisterEdits)
public:
  explicit RegisterEdits(SiteDocument& document) : document_{document} {}

  Result<void> put(const scan::PlaceName& place, const floor::TagUid& uid);
  // Several tags, all of one tile, in one step.

  /// What stood there before a registration that is taken back.
  Result<void> takeBack(const std::vector<scan::Put>& puts);
  /// Two tags took each other's places.
  Result<void> exchange(const std::vector<scan::Put>& puts);
  /// No tag is registered there any more, to be read once more.
  Result<void> readAnew(const std::vector<scan::Put>& puts);
  /// No tag of the tile is registered any more.
  Result<void> clear(const QString& serial);

private:
  Result<void> set(const QString& step, const std::string& serial, std::vector<floor::TagUid> uids);
  Result<void> setAll(const QString& step, const std::vector<scan::Put>& puts);

  SiteDocument& document_;
};

/// Nullptr: the site has no such tile.
[[nodiscard]] const floor::Tile* tileOf(const floor::Site& site, const std::string& serial);

}  // namespace tessera::ui
