// What waits to be stored: filled by the window's thread, emptied by the storage thread, free of Qt. Whoever fills it
// holds the lock for a few moves of pointers and never waits for the disk.
#pragma once

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <variant>
#include <vector>

#include "floor/site_map.h"
#include "locate/magnetic_map.h"
#include "store/journal_entry.h"
#include "store/revision_note.h"

namespace tessera::store {

struct KeepSite {
  std::string key;
  std::shared_ptr<const floor::SiteMap> map;
  std::int64_t utcMs = 0;
  bool differsFromFile = false;
};
struct SetDiffers {
  std::string key;
  bool differsFromFile = false;
};
struct RenameSite {
  std::string from;
  std::string to;
};
struct RemoveSite {
  std::string key;
};
struct AddRevision {
  std::string key;
  std::shared_ptr<const floor::SiteMap> map;
  RevisionNote note;
};
struct CopyRevisions {
  std::string from;
  std::string to;
};
struct KeepMagneticMap {
  std::string key;
  bool simulated = false;
  std::shared_ptr<const locate::MagneticMap> map;
  std::int64_t utcMs = 0;
};
using SiteChange =
    std::variant<KeepSite, SetDiffers, RenameSite, RemoveSite, AddRevision, CopyRevisions, KeepMagneticMap>;

struct LoadSite {
  std::string key;
};
struct ListSites {};
struct ListRevisions {
  std::string key;
};
struct LoadRevision {
  std::int64_t id = 0;
};
struct LoadMagneticMap {
  std::string key;
  bool simulated = false;
};
struct QueryJournal {
  JournalFilter filter;
};
struct Request {
  std::uint64_t id = 0;
  std::variant<LoadSite, ListSites, ListRevisions, LoadRevision, LoadMagneticMap, QueryJournal> what;
};

/// What the storage thread takes at one go. Changes come before notes, notes before the requests that may ask for them.
struct Work {
  std::deque<SiteChange> changes;
  std::vector<Note> notes;
  std::deque<Request> requests;
  std::uint64_t lost = 0;  ///< notes that had to go since the last taking, as there were too many
};

class StoreQueue {
public:
  using Clock = std::chrono::steady_clock;
  struct Limits {
    std::size_t notes = 20'000;
    std::size_t requests = 256;
  };

  explicit StoreQueue(Limits limits) : limits_{limits} {}
  StoreQueue() : StoreQueue{Limits{}} {}

  // From any thread. False: it is closed, or, for requests, full.

  /// A site or a magnetic map that waits already under the same key makes way for its newer state.
  bool change(SiteChange change);
  /// When there are too many the oldest of the least severe go, and are counted.
  bool note(std::vector<Note> notes);
  bool ask(Request request);
  /// Nothing is taken any more; what waits is still handed out.
  void close();

  // From the storage thread.

  /// Waits until there is something, until `deadline`, or until it is closed. With `requestsOnly` all else stays and
  /// waits on (while the disk fails).
  [[nodiscard]] Work take(Clock::time_point deadline, bool requestsOnly);
  /// What could not be stored goes back to the front.
  void giveBack(Work work);
  [[nodiscard]] bool closed() const;
  [[nodiscard]] bool empty() const;

private:
  struct Numbered {
    std::uint64_t number;
    Note note;
  };
  void makeRoom();

  const Limits limits_;
  mutable std::mutex lock_;
  std::condition_variable filled_;
  std::deque<SiteChange> changes_;
  std::array<std::deque<Numbered>, 3> notes_;  // by severity, each in the order of its numbers
  std::deque<Request> requests_;
  std::uint64_t nextNumber_ = std::uint64_t{1} << 32;  // room before it for what is given back
  std::uint64_t lost_ = 0;
  bool closed_ = false;
};

}  // namespace tessera::store
