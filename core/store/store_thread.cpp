#include "store/store_thread.h"

#include <QString>
#include <algorithm>
#include <utility>

#include "store/journal.h"
#include "store/magnetic_maps.h"

namespace tessera::store {
namespace {

using Clock = StoreQueue::Clock;

constexpr std::size_t kNotesBetweenPrunings = 10'000;
constexpr std::chrono::milliseconds kRetryWhenClosing{50};

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

// A site that contradicts itself is kept while it is being mended, too.
Result<std::shared_ptr<const floor::SiteMap>> carried(floor::Site site) {
  return floor::SiteMap::build(std::move(site), floor::Ambiguity::Carried);
}

}  // namespace

// What lives on the storage thread.
class StoreThread::Session {
public:
  explicit Session(StoreThread& owner) : owner_{owner} {}

  void run() {
    Work none;
    write(none);  // opens the file, so that trouble is told at once and not at the first edit
    while (true) {
      // While the disk fails only requests are served until it is time for the next try.
      const bool trying = !failing_ || Clock::now() >= nextTry_;
      Work work = owner_.queue_.take(failing_ ? nextTry_ : Clock::time_point::max(), !trying);
      if (trying || owner_.queue_.closed()) write(work);
      const bool written = work.changes.empty() && work.notes.empty() && work.lost == 0;
      for (Request& request : work.requests) answer(request);
      work.requests.clear();
      if (!written) owner_.queue_.giveBack(std::move(work));
      if (written && !failing_) Q_EMIT owner_.idle();
      if (!owner_.queue_.closed()) continue;
      const bool done = owner_.queue_.empty();
      if (done || Clock::now() >= owner_.lastMoment_.load()) {
        owner_.allWritten_ = done;
        return;
      }
      if (failing_) QThread::msleep(kRetryWhenClosing.count());
    }
  }

private:
  Result<void> open() {
    if (database_) return {};
    auto opened = Database::open(owner_.options_.file, owner_.options_.database);
    if (!opened) return tl::unexpected{opened.error()};
    database_ = std::move(*opened);
    return {};
  }

  /// Takes out of `work` what could be written; the rest stays.
  void write(Work& work) {
    const auto writeAll = [&]() -> Result<void> {
      if (auto ready = open(); !ready) return ready;
      while (!work.changes.empty()) {
        if (auto done = apply(work.changes.front()); !done) return done;
        work.changes.pop_front();
      }
      if (work.lost > 0) {
        const std::int64_t when = work.notes.empty() ? latestUtcMs_ : work.notes.front().utcMs;
        if (auto done = Journal{*database_}.appendLoss(work.lost, when); !done) return done;
        lostInEpisode_ += std::exchange(work.lost, 0);
      }
      if (auto done = Journal{*database_}.append(work.notes); !done) return done;
      remember(work.notes);
      work.notes.clear();
      return {};
    };
    const auto result = writeAll();
    if (!result) {
      pause_ = failing_ ? std::min(2 * pause_, 10 * owner_.options_.retry) : owner_.options_.retry;
      nextTry_ = Clock::now() + pause_;
      if (!std::exchange(failing_, true)) Q_EMIT owner_.failed(result.error().sentence);
      return;
    }
    if (std::exchange(failing_, false)) Q_EMIT owner_.recovered(std::exchange(lostInEpisode_, 0));
    prune();
  }

  Result<void> apply(const SiteChange& change) {
    SiteStore sites{*database_};
    return std::visit(
        Overloaded{
            [&](const KeepSite& c) { return sites.save(c.key, c.map, c.utcMs, c.differsFromFile, last_); },
            [&](const SetDiffers& c) { return sites.setDiffers(c.key, c.differsFromFile); },
            [&](const RenameSite& c) { return sites.rename(c.from, c.to); },
            [&](const RemoveSite& c) { return sites.remove(c.key); },
            [&](const AddRevision& c) -> Result<void> {
              Revisions revisions{*database_};
              if (c.note.found)
                if (auto adopted = revisions.adopt(c.key, c.map->site()); !adopted) return adopted;
              const auto added = revisions.add(c.key, c.map->site(), c.note);
              return added ? Result<void>{} : tl::unexpected{added.error()};
            },
            [&](const CopyRevisions& c) { return Revisions{*database_}.copy(c.from, c.to); },
            [&](const KeepMagneticMap& c) {
              return MagneticMaps{*database_}.save(c.key, c.simulated, *c.map, c.utcMs);
            },
        },
        change);
  }

  void remember(const std::vector<Note>& notes) {
    for (const Note& note : notes) latestUtcMs_ = std::max(latestUtcMs_, note.utcMs);
    notesSincePruning_ += notes.size();
  }

  // What is too old or too much goes now and then; if that fails the next time will do.
  void prune() {
    const bool known = latestUtcMs_ != 0;  // what time it is, from the notes
    if (!known || notesSincePruning_ < kNotesBetweenPrunings || owner_.queue_.closed()) return;
    notesSincePruning_ = 0;
    const auto age = std::chrono::milliseconds{owner_.options_.keepFor}.count();
    static_cast<void>(Journal{*database_}.prune(latestUtcMs_ - age, owner_.options_.keepEntries));
  }

  void answer(const Request& request) {
    const auto refuse = [&](const Error& error) { Q_EMIT owner_.requestFailed(request.id, error.sentence); };
    if (auto ready = open(); !ready) return refuse(ready.error());
    std::visit(Overloaded{
                   [&](const LoadSite& what) {
                     auto site = SiteStore{*database_}.load(what.key);
                     if (!site) return refuse(site.error());
                     if (!*site) return Q_EMIT owner_.siteLoaded(request.id, nullptr);
                     auto map = carried(std::move(**site));
                     if (!map) return refuse(map.error());
                     Q_EMIT owner_.siteLoaded(request.id, *map);
                   },
                   [&](const ListSites&) {
                     const auto sites = SiteStore{*database_}.list();
                     if (!sites) return refuse(sites.error());
                     Q_EMIT owner_.sitesListed(request.id, *sites);
                   },
                   [&](const ListRevisions& what) {
                     const auto revisions = Revisions{*database_}.list(what.key);
                     if (!revisions) return refuse(revisions.error());
                     Q_EMIT owner_.revisionsListed(request.id, *revisions);
                   },
                   [&](const LoadRevision& what) {
                     auto map = Revisions{*database_}.load(what.id).and_then(carried);
                     if (!map) return refuse(map.error());
                     Q_EMIT owner_.revisionLoaded(request.id, *map);
                   },
                   [&](const LoadMagneticMap& what) {
                     const auto map = MagneticMaps{*database_}.load(what.key, what.simulated);
                     if (!map) return refuse(map.error());
                     Q_EMIT owner_.magneticMapLoaded(request.id, *map);
                   },
                   [&](const QueryJournal& what) {
                     const auto page = Journal{*database_}.query(what.filter);
                     if (!page) return refuse(page.error());
                     Q_EMIT owner_.journalFound(request.id, *page);
                   },
               },
               request.what);
  }

  StoreThread& owner_;
  std::unique_ptr<Database> database_;
  LastWritten last_;
  bool failing_ = false;
  Clock::time_point nextTry_{};
  std::chrono::milliseconds pause_{0};
  std::uint64_t lostInEpisode_ = 0;
  std::int64_t latestUtcMs_ = 0;
  std::size_t notesSincePruning_ = kNotesBetweenPrunings;  // so that the first notes of a run see to it
};

StoreThread::StoreThread(Options options, QObject* parent)
    : QObject{parent}, options_{std::move(options)}, queue_{options_.limits} {}

StoreThread::~StoreThread() { close(); }

void StoreThread::start() {
  if (thread_ || closed_) return;
  thread_.reset(QThread::create([this] { Session{*this}.run(); }));
  thread_->setObjectName(QStringLiteral("store"));
  thread_->start(QThread::LowPriority);
}

bool StoreThread::close(std::chrono::milliseconds patience) {
  if (std::exchange(closed_, true)) return allWritten_;
  lastMoment_ = Clock::now() + patience;
  queue_.close();
  if (thread_)
    thread_->wait();
  else
    allWritten_ = queue_.empty();
  return allWritten_;
}

bool StoreThread::keepSite(std::string key, std::shared_ptr<const floor::SiteMap> map, std::int64_t utcMs,
                           bool differsFromFile) {
  return queue_.change(KeepSite{std::move(key), std::move(map), utcMs, differsFromFile});
}

bool StoreThread::setDiffers(std::string key, bool differsFromFile) {
  return queue_.change(SetDiffers{std::move(key), differsFromFile});
}

bool StoreThread::renameSite(std::string from, std::string to) {
  return queue_.change(RenameSite{std::move(from), std::move(to)});
}

bool StoreThread::removeSite(std::string key) { return queue_.change(RemoveSite{std::move(key)}); }

bool StoreThread::addRevision(std::string key, std::shared_ptr<const floor::SiteMap> map, RevisionNote note) {
  return queue_.change(AddRevision{std::move(key), std::move(map), std::move(note)});
}

bool StoreThread::copyRevisions(std::string from, std::string to) {
  return queue_.change(CopyRevisions{std::move(from), std::move(to)});
}

bool StoreThread::keepMagneticMap(std::string key, bool simulated, std::shared_ptr<const locate::MagneticMap> map,
                                  std::int64_t utcMs) {
  return queue_.change(KeepMagneticMap{std::move(key), simulated, std::move(map), utcMs});
}

bool StoreThread::appendEvents(std::vector<Note> notes) { return queue_.note(std::move(notes)); }

std::uint64_t StoreThread::ask(decltype(Request::what) what) {
  const std::uint64_t id = nextRequest_++;
  return queue_.ask({id, std::move(what)}) ? id : 0;
}

std::uint64_t StoreThread::loadSite(std::string key) { return ask(LoadSite{std::move(key)}); }
std::uint64_t StoreThread::listSites() { return ask(ListSites{}); }
std::uint64_t StoreThread::listRevisions(std::string key) { return ask(ListRevisions{std::move(key)}); }
std::uint64_t StoreThread::loadRevision(std::int64_t id) { return ask(LoadRevision{id}); }
std::uint64_t StoreThread::loadMagneticMap(std::string key, bool simulated) {
  return ask(LoadMagneticMap{std::move(key), simulated});
}
std::uint64_t StoreThread::queryJournal(JournalFilter filter) { return ask(QueryJournal{std::move(filter)}); }

}  // namespace tessera::store
