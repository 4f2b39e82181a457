#include "store/store_queue.h"

#include <algorithm>
#include <iterator>

namespace tessera::store {
namespace {

// The waiting change that keeps the same site: only back to the last one of another kind, as a site must not be kept
// before it is renamed. Nullptr: there is none.
template <class Changes>
SiteChange* replaceable(Changes& changes, const SiteChange& change) {
  if (const auto* magnetic = std::get_if<KeepMagneticMap>(&change)) {
    for (SiteChange& other : changes) {
      const auto* waiting = std::get_if<KeepMagneticMap>(&other);
      if (waiting != nullptr && waiting->key == magnetic->key && waiting->simulated == magnetic->simulated)
        return &other;
    }
    return nullptr;
  }
  const auto* keep = std::get_if<KeepSite>(&change);
  if (keep == nullptr) return nullptr;
  for (auto it = changes.rbegin(); it != changes.rend(); ++it) {
    const auto* waiting = std::get_if<KeepSite>(&*it);
    if (waiting == nullptr) return nullptr;
    if (waiting->key == keep->key) return &*it;
  }
  return nullptr;
}

std::size_t rank(const Note& note) { return static_cast<std::size_t>(note.event.severity); }

}  // namespace

bool StoreQueue::change(SiteChange change) {
  {
    const std::lock_guard hold{lock_};
    if (closed_) return false;
    // The old one dies below, outside the lock.
    if (SiteChange* older = replaceable(changes_, change))
      std::swap(*older, change);
    else
      changes_.push_back(std::move(change));
  }
  filled_.notify_one();
  return true;
}

bool StoreQueue::note(std::vector<Note> notes) {
  {
    const std::lock_guard hold{lock_};
    if (closed_) return false;
    for (Note& note : notes) {
      const std::size_t at = rank(note);
      notes_[at].push_back({nextNumber_++, std::move(note)});
    }
    makeRoom();
  }
  filled_.notify_one();
  return true;
}

bool StoreQueue::ask(Request request) {
  {
    const std::lock_guard hold{lock_};
    if (closed_ || requests_.size() >= limits_.requests) return false;
    requests_.push_back(std::move(request));
  }
  filled_.notify_one();
  return true;
}

void StoreQueue::close() {
  {
    const std::lock_guard hold{lock_};
    closed_ = true;
  }
  filled_.notify_all();
}

Work StoreQueue::take(Clock::time_point deadline, bool requestsOnly) {
  Work work;
  std::unique_lock hold{lock_};
  const auto notesWait = [this] {
    return std::any_of(notes_.begin(), notes_.end(), [](const auto& some) { return !some.empty(); });
  };
  filled_.wait_until(hold, deadline, [&] {
    return closed_ || !requests_.empty() || (!requestsOnly && (!changes_.empty() || notesWait()));
  });
  std::array<std::deque<Numbered>, 3> notes;
  if (!requestsOnly || closed_) {
    work.changes.swap(changes_);
    notes.swap(notes_);
    work.lost = std::exchange(lost_, 0);
  }
  work.requests.swap(requests_);
  hold.unlock();
  std::vector<Numbered> all;
  for (auto& some : notes) std::move(some.begin(), some.end(), std::back_inserter(all));
  std::sort(all.begin(), all.end(), [](const Numbered& a, const Numbered& b) { return a.number < b.number; });
  work.notes.reserve(all.size());
  for (Numbered& one : all) work.notes.push_back(std::move(one.note));
  return work;
}

void StoreQueue::giveBack(Work work) {
  const std::lock_guard hold{lock_};
  changes_.insert(changes_.begin(), std::move_iterator{work.changes.begin()}, std::move_iterator{work.changes.end()});
  // Numbers before all that wait keep the order.
  std::uint64_t first = nextNumber_;
  for (const auto& some : notes_)
    if (!some.empty()) first = std::min(first, some.front().number);
  for (auto note = work.notes.rbegin(); note != work.notes.rend(); ++note)
    notes_[rank(*note)].push_front({--first, std::move(*note)});
  lost_ += work.lost;
  makeRoom();
}

bool StoreQueue::closed() const {
  const std::lock_guard hold{lock_};
  return closed_;
}

bool StoreQueue::empty() const {
  const std::lock_guard hold{lock_};
  return changes_.empty() && requests_.empty() &&
         std::all_of(notes_.begin(), notes_.end(), [](const auto& some) { return some.empty(); });
}

void StoreQueue::makeRoom() {
  std::size_t waiting = 0;
  for (const auto& some : notes_) waiting += some.size();
  for (auto& some : notes_) {
    while (waiting > limits_.notes && !some.empty()) {
      some.pop_front();
      --waiting;
      ++lost_;
    }
  }
}

}  // namespace tessera::store
