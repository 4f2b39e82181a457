#include "supervisor/command_history.h"

#include <algorithm>
#include <cmath>

#include "locate/locator.h"

namespace tessera::supervisor {
namespace {

constexpr std::size_t kMostOpen = 3;   // that may or may not have been taken; older ones count as taken
constexpr double kSameSpeed = 0.005;   // m/s; a command that differs by less from what is in force changes nothing
constexpr double kSameHeading = 0.03;  // rad
constexpr double kLearning = 1.0 / 32.0;
constexpr double kLeastUnanswered = 0.02;

bool alike(const std::optional<drive::Command>& a, const std::optional<drive::Command>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return abs(a->speed - b->speed).value() < kSameSpeed &&
         std::abs(turnBetween(a->heading, b->heading).value()) < kSameHeading;
}

}  // namespace

void CommandHistory::drive(const drive::Command& command, Seconds from, Seconds expiry, std::uint32_t counter) {
  put({command, from, from + expiry, counter, Fate::UnderWay});
}

void CommandHistory::stand(Seconds from, std::uint32_t counter) {
  put({std::nullopt, from, from, counter, Fate::UnderWay});
}

void CommandHistory::put(Entry entry) {
  // The instants are estimates and may cross when the measured latency changes: the later command still wins.
  while (!entries_.empty() && entries_.back().from >= entry.from) entries_.pop_back();
  entries_.push_back(entry);
  const auto old = [&](const Entry& e) { return e.until < entry.from - locate::Locator::kHistory; };
  entries_.erase(entries_.begin(), std::find_if_not(entries_.begin(), entries_.end(), old));
}

// Whether an earlier one was taken hardly matters any more: what is known comes from the report that tells of this one,
// which was made after it.
void CommandHistory::taken(std::uint32_t counter) {
  unanswered_ = std::max(kLeastUnanswered, unanswered_ - kLearning * unanswered_);
  const auto at = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.counter == counter; });
  if (at == entries_.end()) return;
  for (auto e = entries_.begin(); e <= at; ++e) e->fate = Fate::Taken;
}

void CommandHistory::unanswered(std::uint32_t counter) {
  unanswered_ += kLearning * (1.0 - unanswered_);
  for (Entry& e : entries_)
    if (e.counter == counter && e.fate == Fate::UnderWay) e.fate = Fate::Unanswered;
}

bool CommandHistory::holdsAfter(Seconds at) const {
  return std::any_of(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.command && e.until > at; });
}

// Of those not acknowledged the newest that would not do what is surely in force anyway.
std::vector<std::size_t> CommandHistory::open() const {
  std::vector<std::size_t> found;
  const Entry* sure = nullptr;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const Entry& e = entries_[i];
    const bool alone = sure == nullptr || !alike(e.command, sure->command) || (e.command && e.from > sure->until);
    if (e.fate != Fate::Taken && alone)
      found.push_back(i);
    else
      sure = &e;
  }
  if (found.size() > kMostOpen) found.erase(found.begin(), found.end() - kMostOpen);
  return found;
}

double CommandHistory::chanceOfLoss(const Entry& entry) const {
  return entry.fate == Fate::Unanswered ? 0.5 : 0.5 * unanswered_;
}

std::vector<CommandHistory::Case> CommandHistory::cases() const {
  const std::vector<std::size_t> open = this->open();
  std::vector<Case> cases(std::size_t{1} << open.size());
  for (std::size_t number = 0; number < cases.size(); ++number) {
    Case& one = cases[number];
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      const Entry& e = entries_[i];
      const auto at = std::find(open.begin(), open.end(), i);
      if (at != open.end()) {
        const bool lost = ((number >> static_cast<std::size_t>(at - open.begin())) & 1U) != 0;
        one.chance *= lost ? chanceOfLoss(e) : 1.0 - chanceOfLoss(e);
        if (lost) continue;
      }
      if (!one.commands.empty()) one.commands.back().until = std::min(one.commands.back().until, e.from);
      if (e.command) one.commands.push_back({*e.command, e.from, e.until});
    }
  }
  return cases;
}

}  // namespace tessera::supervisor
