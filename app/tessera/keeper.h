// Keeps what must not be lost: the open site with every edit, and the journal of what happened. It puts both on the
// storage thread; the window waits for neither.
#pragma once

#include <QDateTime>
#include <QObject>
#include <QTimer>
#include <memory>
#include <string>
#include <vector>

#include "floor/site_map.h"
#include "store/store_thread.h"
#include "ui/base/fleet_link.h"
#include "ui/base/site_document.h"
#include "ui/fleet/event_model.h"

namespace tessera::desktop {

class Keeper : public QObject {
  Q_OBJECT
public:
  Keeper(ui::SiteDocument& document, ui::FleetLink& fleet, QObject* parent = nullptr);
  ~Keeper() override;

  /// What an earlier run left unsaved of the site in this file; null: nothing.
  [[nodiscard]] std::shared_ptr<const floor::SiteMap> unsaved(const QString& path);
  /// The open site was saved to this file.
  void onSaved(const QString& path);
  /// Changes to this file's site, or with an empty path to the open one, shall be forgotten.
  void onGivenUp(const QString& path);
  /// Keeps the open site as it stands now, not a moment later.
  void keepNow() { keepSite(document_.isModified()); }
  /// Asks for the journal's end, which comes with historyLoaded().
  void loadHistory();
  /// Writes what waits. False: not all could be written.
  bool close();

  /// The wall clock's time of an instant of the supervision.
  [[nodiscard]] static QDateTime wallClock(Seconds instant);
  [[nodiscard]] static QString databasePath();

Q_SIGNALS:
  void historyLoaded(const std::vector<tessera::ui::JournalLine>& lines);
  /// A complete sentence.
  void failed(const QString& sentence);

private:
  void keepSite(bool differsFromFile);
  void note(const std::vector<supervisor::Event>& events);

  ui::SiteDocument& document_;
  std::unique_ptr<store::StoreThread> store_;
  QTimer edits_;
  std::string key_;  // of the open site
  quint64 history_ = 0;
};

}  // namespace tessera::desktop
