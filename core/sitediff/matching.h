// Items of two lists that go by the same name. For this folder's sources.
#pragma once

#include <cstdio>
#include <map>
#include <utility>
#include <vector>

#include "sitediff/difference.h"

namespace tessera::sitediff {

/// Calls visit(before, after) with nullptr for what is missing: first what is gone and what stayed, in the order of
/// `before`, then what is new.
template <class Items, class KeyOf, class Visit>
void match(const Items& before, const Items& after, KeyOf keyOf, Visit visit) {
  using Item = typename Items::value_type;
  // The k-th item of a key goes with the k-th.
  std::map<std::pair<decltype(keyOf(*before.begin())), std::size_t>, const Item*> index;
  std::map<decltype(keyOf(*before.begin())), std::size_t> seen;
  for (const Item& item : after) {
    const auto key = keyOf(item);
    index.emplace(std::pair{key, seen[key]++}, &item);
  }
  seen.clear();
  for (const Item& item : before) {
    const auto key = keyOf(item);
    const auto found = index.find({key, seen[key]++});
    visit(&item, found == index.end() ? nullptr : found->second);
  }
  std::map<decltype(keyOf(*before.begin())), std::size_t> had = std::move(seen);
  seen.clear();
  for (const Item& item : after) {
    const auto key = keyOf(item);
    const auto known = had.find(key);
    if (seen[key]++ >= (known == had.end() ? 0 : known->second)) visit(nullptr, &item);
  }
}

[[nodiscard]] inline std::string decimals(double value, int digits) {
  char text[400];
  std::snprintf(text, sizeof text, "%.*f", digits, value == 0.0 ? 0.0 : value);
  return text;
}
[[nodiscard]] inline std::string placed(Point p) {
  return "(" + decimals(p.x.value(), 2) + ", " + decimals(p.y.value(), 2) + ")";
}

/// Sentences that all subjects share; who: 'Tile "T-1"'.
class Teller {
public:
  Teller(Changes& into, Subject subject) : into_{into}, subject_{subject} {}
  void added(const std::string& name, const Sentence& who, const std::optional<Box>& place) {
    tell(ChangeKind::Added, name, phrase("Core", "%1 is new.").with(who), place);
  }
  void removed(const std::string& name, const Sentence& who, const std::optional<Box>& place) {
    tell(ChangeKind::Removed, name, phrase("Core", "%1 is gone.").with(who), place);
  }
  void moved(const std::string& name, const Sentence& who, Point from, Point to) {
    const Point ends[] = {from, to};
    tell(ChangeKind::Moved, name, phrase("Core", "%1 moves from %2 to %3 m.").with(who, placed(from), placed(to)),
         boxAround(ends));
  }
  /// what: "another outline".
  void changed(const std::string& name, const Sentence& who, const Sentence& what, const std::optional<Box>& place) {
    tell(ChangeKind::Changed, name, phrase("Core", "%1: %2.").with(who, what), place);
  }
  void tell(ChangeKind kind, const std::string& name, const Sentence& sentence, const std::optional<Box>& place) {
    into_.push_back({kind, subject_, name, sentence, place});
  }

private:
  Changes& into_;
  Subject subject_;
};

void tileDifference(const floor::Site& before, const floor::Site& after, Changes& changes);

}  // namespace tessera::sitediff
