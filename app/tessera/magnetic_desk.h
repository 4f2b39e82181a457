// The magnetic map of the open site's floor, between storage, supervision and canvas: given to each supervision as it
// begins, taken from its pictures, kept now and then.
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
  void onSessionState();
  void onSnapshot();
  void hand();
  void show(std::shared_ptr<const locate::MagneticMap> map);

  FleetSession& session_;
  Keeper& keeper_;
  ui::FloorCanvas& canvas_;
  QTimer minute_;
  std::string key_;         ///< of the site whose map it is
  bool simulated_ = false;  ///< it was learned in the simulated world
  std::shared_ptr<const locate::MagneticMap> map_ = std::make_shared<locate::MagneticMap>();
  bool awaited_ = false;  ///< the supervision does not have the map yet: what it shows is of another floor
  bool unkept_ = false;
};

}  // namespace tessera::desktop
