// Keeps what must not be lost: the open site with every edit, and the journal of what happened. It puts both on the
// storage thread; the window waits for neither.
#pragma once

#include <QDateTime>
#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/tessera/site_lock.h"
#include "floor/site_map.h"
#include "store/store_thread.h"
#include "ui/base/fleet_link.h"
#include "ui/base/site_document.h"
#include "ui/fleet/event_model.h"
#include "ui/fleet/journal.h"

namespace tessera::desktop {

class Keeper : public QObject {
  Q_OBJECT
public:
  Keeper(ui::SiteDocument& document, ui::FleetLink& fleet, QObject* parent = nullptr);
  ~Keeper() override;

  /// What an earlier run left unsaved of the site in this file; null: nothing.
  [[nodiscard]] std::shared_ptr<const floor::SiteMap> unsaved(const QString& path);
  /// The process of another copy of the program that has the site in this file open; nullopt: none.
  [[nodiscard]] std::optional<qint64> holderOf(const QString& path) const;
  /// A site that an earlier run left behind unsaved and without a file.
  struct Homeless {
    std::string key;
    QDateTime when;  ///< kept last
    std::shared_ptr<const floor::SiteMap> map;
  };
  /// The latest first.
  [[nodiscard]] std::vector<Homeless> homeless();
  /// The open site is the one that was kept under this key.
  void goOnAs(const std::string& key) {
    use(key);
    Q_EMIT keyChanged({});
  }
  /// Under which the open site is kept.
  [[nodiscard]] const std::string& key() const { return key_; }
  void forget(const std::string& key) { store_->removeSite(key); }
  /// The open site was saved to this file.
  void onSaved(const QString& path);
  /// Changes to this file's site, or with an empty path to the open one, shall be forgotten.
  void onGivenUp(const QString& path);
  /// Keeps the open site as it stands now, not a moment later.
  void keepNow() { keepSite(document_.isModified()); }
  /// Asks for the journal's end, which comes with historyLoaded().
  void loadHistory();
  /// Asks for a day of the journal, which comes with dayRead() page by page, unless another one is asked for.
  void readDay(const ui::JournalDay& day);
  /// The open site as it stands now becomes a revision of its file.
  void addRevision(const store::RevisionNote& note) { addRevision(note, document_.map()); }
  /// And so does what another program saved to its file.
  void addRevision(const store::RevisionNote& note, const std::shared_ptr<const floor::SiteMap>& map);
  /// Of a site without a file nothing is kept.
  void keepMagneticMap(const std::string& key, bool simulated, std::shared_ptr<const locate::MagneticMap> map);
  /// Each gives the number under which its answer comes; 0: it cannot be asked just now.
  quint64 listRevisions();
  quint64 loadRevision(qint64 id);
  /// What was learned of the iron in the floor that is kept under this key.
  quint64 loadMagneticMap(const std::string& key, bool simulated);
  /// Writes what waits. False: not all could be written.
  bool close();

  /// The wall clock's time of an instant of the supervision.
  [[nodiscard]] static QDateTime wallClock(Seconds instant);
  [[nodiscard]] static QString databasePath();

Q_SIGNALS:
  void historyLoaded(const std::vector<tessera::ui::JournalLine>& lines);
  void dayRead(const std::vector<tessera::ui::JournalLine>& lines, tessera::ui::JournalPart part);
  /// Complete sentences.
  void dayFailed(const QString& sentence);
  void failed(const QString& sentence);
  /// What could not be written is written now.
  void recovered();
  void revisionsListed(quint64 request, const std::vector<tessera::store::Revision>& revisions);
  void revisionLoaded(quint64 request, const std::shared_ptr<const tessera::floor::SiteMap>& map);
  /// Null: nothing is kept.
  void magneticMapLoaded(quint64 request, const std::shared_ptr<const tessera::locate::MagneticMap>& map);
  void requestFailed(quint64 request, const QString& sentence);
  /// The open site is kept under another key from now on. What is kept elsewhere under `before` should come along when
  /// it is the same site still, as after saving it under another name; `before` is empty when it is not.
  void keyChanged(const QString& before);

private:
  void keepSite(bool differsFromFile);
  void use(const std::string& key);
  void note(const std::vector<supervisor::Event>& events);

  ui::SiteDocument& document_;
  std::unique_ptr<store::StoreThread> store_;
  QTimer edits_;
  std::string key_;  // of the open site
  SiteLock lock_;
  void askForPage();
  void takePage(const store::JournalPage& page);

  quint64 history_ = 0;
  quint64 page_ = 0;  // of the day that was asked for last
  store::JournalFilter day_;
  std::size_t ofDay_ = 0;  // so many lines of it have come
};

}  // namespace tessera::desktop
