// A floor of two tiles with 8 tags each, and a person with a reader before it.
#pragma once

#include <gtest/gtest.h>

#include <array>

#include "floor/new_floor.h"
#include "scan/registration.h"

namespace tessera::scan {

using Verdict = Answer::Verdict;

inline floor::TagUid uid(unsigned n) {
  const std::array<std::uint8_t, 4> bytes{0x04, static_cast<std::uint8_t>(n >> 16U), static_cast<std::uint8_t>(n >> 8U),
                                          static_cast<std::uint8_t>(n)};
  return floor::TagUid::fromBytes(bytes).value();
}

class ScanWalk : public testing::Test {
protected:
  std::shared_ptr<const floor::SiteMap> map =
      floor::SiteMap::build(floor::layNewFloor({"f", floor::usualTileTypes().front(), 2, 1, false}).value()).value();
  Seconds now{100.0};
  std::optional<Registration> person;

  void SetUp() override { person.emplace(map, Course{}); }

  std::shared_ptr<const floor::SiteMap> with(const PlaceName& place, const floor::TagUid& u) const {
    floor::Site site = map->site();
    for (auto& tile : site.tiles) {
      if (tile.serial != place.serial) continue;
      if (tile.uids.size() <= place.tag) tile.uids.resize(place.tag + 1);
      tile.uids[place.tag] = u;
    }
    return floor::SiteMap::build(site).value();
  }
  Verdict scan(unsigned n, std::optional<Point> place = {}) {
    now += Seconds{2.0};
    last = person->offer({uid(n), place}, now);
    if (last.verdict == Verdict::Accepted || last.verdict == Verdict::Confirmed) {
      map = with(here(), uid(n));
      person->registered(map, uid(n), now);
    }
    return last.verdict;
  }
  void put(const std::vector<Put>& puts) {
    floor::Site site = map->site();
    for (const Put& p : puts)
      for (auto& tile : site.tiles) {
        if (tile.serial != p.place.serial) continue;
        if (tile.uids.size() <= p.place.tag) tile.uids.resize(p.place.tag + 1);
        tile.uids[p.place.tag] = p.uid;
      }
    map = floor::SiteMap::build(site).value();
  }
  void back() {
    put(person->back());
    person->restored(map);
  }
  void exchange(unsigned n) {
    const auto puts = person->exchange(uid(n));
    ASSERT_EQ(puts.size(), 2U);
    put(puts);
    person->registered(map, uid(n), now);
  }
  void readAnew() {
    put(person->anew());
    person->cleared(map);
  }
  [[nodiscard]] PlaceName here() const { return nameOf(map->site(), *person->stop()); }
  [[nodiscard]] std::size_t registered() const { return person->progress().registered; }

  Answer last;
};

}  // namespace tessera::scan
