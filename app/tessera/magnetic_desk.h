// The magnetic map of the open site's floor, between storage, supervision and canvas: given to each supervision as it
// begins, taken from its pictures, kept now and then. What is stored comes a moment after the site was opened; until
// then the map is empty and nothing is learned.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <string>

#include "app/tessera/fleet_session.h"
#include "app/tessera/keeper.h"
#include "locate/magnetic_map.h"
#include "ui/canvas/floor_canvas.h"

namespace tessera::desktop {

class MagneticDesk : public QObject {
  Q_OBJECT
public:
  /// All must outlive it.
  MagneticDesk(ui::SiteDocument& document, FleetSession& session, Keeper& keeper, ui::FloorCanvas& canvas);
  ~MagneticDesk() override;

  /// Never null.
  [[nodiscard]] const std::shared_ptr<const locate::MagneticMap>& map() const { return map_; }
  /// What is stored of the site's floor has not come yet.
  [[nodiscard]] bool isLoading() const { return asked_ != 0; }
  /// For good; what is stored goes as well.
  void forget();
  /// Hands what is new to the storage.
  void keep();

Q_SIGNALS:
  /// map() is another.
  void changed();
  /// A complete sentence.
  void failed(const QString& sentence);

private:
  void open(const std::string& key, bool simulated);
  void onLoaded(const std::shared_ptr<const locate::MagneticMap>& map);
  void onFailed(const QString& sentence);
  void onSessionState();
  void onSnapshot();
  void hand();
  void show(std::shared_ptr<const locate::MagneticMap> map);

  FleetSession& session_;
  Keeper& keeper_;
  ui::FloorCanvas& canvas_;
  QTimer minute_;
  std::string key_;  ///< of the site whose map it is
  quint64 asked_ = 0;
  std::string askedKey_;    ///< key_ may have become another since
  bool simulated_ = false;  ///< it was learned in the simulated world
  std::shared_ptr<const locate::MagneticMap> map_ = std::make_shared<locate::MagneticMap>();
  bool awaited_ = false;  ///< the supervision does not have the map yet: what it shows is of another floor
  bool unkept_ = false;
};

}  // namespace tessera::desktop
