// Storage on a thread of its own: the window posts what is to be kept and goes on; answers and troubles come back as
// signals. While the disk fails everything waits and is tried again; nothing is lost but, when far too much waits, the
// oldest of the least severe notes, and that is told.
#pragma once

#include <QObject>
#include <QThread>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <memory>
#include <vector>

#include "base/sentence.h"
#include "store/database.h"
#include "store/revisions.h"
#include "store/site_store.h"
#include "store/store_queue.h"

namespace tessera::store {

class StoreThread : public QObject {
  Q_OBJECT
public:
  struct Options {
    std::filesystem::path file;
    Database::Options database;
    StoreQueue::Limits limits;
    std::chrono::milliseconds retry{1000};  ///< after a failure; doubles up to ten times as long
    std::int64_t keepEntries = 1'000'000;   ///< of the journal
    std::chrono::hours keepFor{24 * 366};
  };

  explicit StoreThread(Options options, QObject* parent = nullptr);
  /// Closes, if that has not been done.
  ~StoreThread() override;

  void start();
  /// Writes all that waits, then joins the thread. Gives up `patience` after the call when the disk still fails; what
  /// is being written just then is finished first. True: all is written.
  bool close(std::chrono::milliseconds patience = std::chrono::milliseconds{3000});

  // From any thread. False: it is closed.

  bool keepSite(std::string key, std::shared_ptr<const floor::SiteMap> map, std::int64_t utcMs, bool differsFromFile);
  bool setDiffers(std::string key, bool differsFromFile);
  bool renameSite(std::string from, std::string to);
  bool removeSite(std::string key);
  /// As Revisions::add(), and Revisions::adopt() before it for a file that was found as it was opened.
  bool addRevision(std::string key, std::shared_ptr<const floor::SiteMap> map, RevisionNote note);
  /// As Revisions::copy().
  bool copyRevisions(std::string from, std::string to);
  bool keepMagneticMap(std::string key, bool simulated, std::shared_ptr<const locate::MagneticMap> map,
                       std::int64_t utcMs);
  bool appendEvents(std::vector<Note> notes);

  // Requests, from any thread; each gives the number under which its answer comes. 0: closed, or too many wait.

  std::uint64_t loadSite(std::string key);
  std::uint64_t listSites();
  std::uint64_t listRevisions(std::string key);
  std::uint64_t loadRevision(std::int64_t id);
  /// Comes with what was posted by keepMagneticMap() before.
  std::uint64_t loadMagneticMap(std::string key, bool simulated);
  std::uint64_t queryJournal(JournalFilter filter);

Q_SIGNALS:
  /// Null: nothing is kept under this key.
  void siteLoaded(quint64 request, const std::shared_ptr<const tessera::floor::SiteMap>& map);
  /// The latest first.
  void sitesListed(quint64 request, const std::vector<tessera::store::KeptSite>& sites);
  void revisionsListed(quint64 request, const std::vector<tessera::store::Revision>& revisions);
  void revisionLoaded(quint64 request, const std::shared_ptr<const tessera::floor::SiteMap>& map);
  /// Null: nothing is kept under this key.
  void magneticMapLoaded(quint64 request, const std::shared_ptr<const tessera::locate::MagneticMap>& map);
  void journalFound(quint64 request, const tessera::store::JournalPage& page);
  void requestFailed(quint64 request, const tessera::Sentence& sentence);

  /// Something cannot be written and is tried again and again. Once, until recovered() follows.
  void failed(const tessera::Sentence& sentence);
  /// All that waited is written, but for so many notes of the journal.
  void recovered(quint64 notesLost);
  /// Everything posted before this is on its way to the disk.
  void idle();

private:
  class Session;
  std::uint64_t ask(decltype(Request::what) what);

  const Options options_;
  StoreQueue queue_;
  std::unique_ptr<QThread> thread_;
  std::atomic<std::uint64_t> nextRequest_{1};
  std::atomic<StoreQueue::Clock::time_point> lastMoment_{StoreQueue::Clock::time_point::max()};
  std::atomic<bool> allWritten_{true};
  bool closed_ = false;
};

}  // namespace tessera::store
