// One person's way over a floor with a reader: which place is next, what a read means there, what can be taken back.
// It changes no site: what it accepts its holder writes into the site, and tells.
#pragma once

#include <memory>
#include <vector>

#include "floor/site_map.h"
#include "scan/pace.h"
#include "scan/tag_line.h"
#include "scan/walk.h"

namespace tessera::scan {

/// What to visit, and from where on: enough to go on after the program ended.
struct Course {
  WalkOrder order = WalkOrder::TilesAlongFloor;
  std::string tile;    ///< this one alone; empty: the floor
  bool again = false;  ///< registered places are visited as well
  std::optional<PlaceName> at;
  std::vector<PlaceName> skipped;
  bool operator==(const Course&) const = default;
};

struct Answer {
  enum class Verdict {
    Accepted,   ///< to be written into the site at the place, then registered() told
    Confirmed,  ///< it is what stands there already
    Repeated,   ///< the same card, still or again: nothing to say
    InUse,      ///< registered elsewhere
    Elsewhere,  ///< the tag itself says that it lies elsewhere
    Finished,   ///< no place is left
  };
  Verdict verdict = Verdict::Finished;
  Sentence sentence{};               ///< why not
  std::optional<PlaceName> where{};  ///< InUse and Elsewhere, where it is a tile's place
};

class Registration {
public:
  /// The same card seen again so soon was never taken away.
  static constexpr Seconds kSameVisit{0.7};
  /// A tag's own place this near is the same place.
  static constexpr Metres kSamePlace{0.05};

  Registration(std::shared_ptr<const floor::SiteMap> map, Course course);

  /// The site was edited, by whoever it was; a registration that was undone brings the walk back to its place.
  void siteChanged(std::shared_ptr<const floor::SiteMap> map);
  [[nodiscard]] const floor::Site& site() const { return map_->site(); }

  /// Nullptr: finished.
  [[nodiscard]] const Stop* stop() const { return at_ ? &walk_[*at_] : nullptr; }
  [[nodiscard]] const std::vector<Stop>& walk() const { return walk_; }
  [[nodiscard]] Course course() const;

  [[nodiscard]] Answer offer(const TagRead& read, Seconds now);
  /// The UID that was accepted, or confirmed, stands in the site at this place: onwards. In place of siteChanged().
  void registered(std::shared_ptr<const floor::SiteMap> map, const floor::TagUid& uid, Seconds now);
  void skip();
  /// To the neighbouring place in the order, registered or not. False: there is none.
  bool next();
  bool previous();
  bool goTo(const PlaceName& place);
  /// Skipped places are to be visited after all.
  void takeUpSkipped();
  void pause() { pace_.pause(); }

  struct Step {
    PlaceName place;
    floor::TagUid before;  ///< what to put there again
    bool wasRegistered = false;
  };
  /// One step back to where the last tag was registered or skipped. Nullopt: there is none behind; it went to the
  /// previous place then.
  [[nodiscard]] std::optional<Step> back();

  struct Progress {
    std::size_t places = 0;
    std::size_t registered = 0;
    std::size_t skipped = 0;
    std::size_t left = 0;
    std::optional<Seconds> perTag;
    std::optional<Seconds> timeLeft;
  };
  [[nodiscard]] Progress progress() const;

private:
  struct Done {
    std::size_t stop;
    floor::TagUid before;
    floor::TagUid uid;  ///< empty: skipped
  };
  [[nodiscard]] bool isOpen(std::size_t stop) const { return !skipped_[stop] && uidAt(site(), walk_[stop]).empty(); }
  [[nodiscard]] std::optional<std::size_t> find(const PlaceName& place) const;
  [[nodiscard]] std::optional<std::size_t> openFrom(std::size_t stop) const;
  [[nodiscard]] Answer place(const TagRead& read) const;
  void moveOn();
  void rebuild();

  std::shared_ptr<const floor::SiteMap> map_;
  Course course_;
  std::vector<Stop> walk_;
  std::vector<bool> skipped_;
  std::optional<std::size_t> at_;
  std::vector<Done> done_;
  floor::TagUid last_;  ///< accepted last: its card may lie on the reader still
  floor::TagUid seen_;
  Seconds seenAt_;
  Pace pace_;
};

}  // namespace tessera::scan
