// Follows the vehicles while they drive over the floor, and knows how far it is checked.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>

#include "ui/base/fleet_link.h"
#include "ui/base/site_document.h"
#include "ui/canvas/tile_marks.h"
#include "ui/tilecheck/read_collector.h"

namespace tessera::ui {

class TileWatch : public QObject {
  Q_OBJECT
public:
  /// Both must outlive it.
  TileWatch(SiteDocument& document, FleetLink& fleet);

  struct Progress {
    int tiles = 0;
    int confirmed = 0;
    int seen = 0;
    int suspect = 0;
    [[nodiscard]] int untouched() const { return tiles - confirmed - seen - suspect; }
    bool operator==(const Progress&) const = default;
  };

  [[nodiscard]] bool isRunning() const { return running_; }
  /// What was read so far stays; false: reads are passed over from now on.
  void setRunning(bool running);
  /// Forgets what was read.
  void reset();

  [[nodiscard]] const Progress& progress() const { return progress_; }
  [[nodiscard]] const std::vector<tilecheck::TileSuspect>& suspects() const { return result_.suspects; }
  /// Tags that are others than the site says.
  [[nodiscard]] const std::vector<tilecheck::TagFinding>& findings() const { return findings_; }
  /// Of the tiles that were driven over.
  [[nodiscard]] std::vector<TileMark> marks() const;
  /// Where the suspect's tiles lie by the site; empty: one of them does not lie any more.
  [[nodiscard]] SiteBox placeOf(const tilecheck::TileSuspect& suspect) const;
  /// The tiles come to lie where they were read, as one step. Error: the site was edited meanwhile; nothing changed.
  Result<void> mend(const tilecheck::TileSuspect& suspect);
  /// The tag that was read comes to stand at its place. Requires a fix.
  Result<void> mend(const tilecheck::TagFinding& finding);

Q_SIGNALS:
  void changed();

private:
  void takeSnapshot();
  void documentChanged();
  void soon();
  void check();
  Result<void> apply(const QString& name, const std::function<bool(floor::Site&)>& edit);

  SiteDocument& document_;
  FleetLink& fleet_;
  ReadCollector collector_;
  bool running_ = false;
  std::shared_ptr<const floor::SiteMap> checked_;
  tilecheck::TileCheckResult result_;
  std::vector<tilecheck::TagFinding> findings_;
  Progress progress_;
  QTimer soon_;
};

}  // namespace tessera::ui
