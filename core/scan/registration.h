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
    Accepted,    ///< to be written into the site at the place, then registered() told
    Confirmed,   ///< it is what stands there already
    Repeated,    ///< the same card, still or again: nothing to say
    InUse,       ///< registered elsewhere
    OnThisTile,  ///< registered at another place of this tile: exchange() and anew() are what can be done about it
    Elsewhere,   ///< the tag itself says that it lies elsewhere
    Finished,    ///< no place is left
  };
  Verdict verdict = Verdict::Finished;
  Sentence sentence{};               ///< why not
  std::optional<PlaceName> where{};  ///< InUse, OnThisTile and Elsewhere, where it is a tile's place
};

/// What is to stand at a place; empty: no tag is registered there.
struct Put {
  PlaceName place;
  floor::TagUid uid;
  bool operator==(const Put&) const = default;
};

class Registration {
public:
  /// The same card seen again so soon was never taken away.
  static constexpr Seconds kSameVisit{0.7};
  /// A tag's own place this near is the same place.
  static constexpr Metres kSamePlace{0.05};

  Registration(std::shared_ptr<const floor::SiteMap> map, Course course);

  /// The site was edited, by whoever it was; a registration that was undone brings the walk back to its place. Returns
  /// the tags that are registered no more thereby; nullopt: no registration was undone.
  std::optional<std::vector<floor::TagUid>> siteChanged(std::shared_ptr<const floor::SiteMap> map);
  [[nodiscard]] const floor::Site& site() const { return map_->site(); }

  /// Nullptr: finished.
  [[nodiscard]] const Stop* stop() const { return at_ ? &walk_[*at_] : nullptr; }
  [[nodiscard]] const std::vector<Stop>& walk() const { return walk_; }
  [[nodiscard]] Course course() const;
  /// Registered places as well.
  [[nodiscard]] bool visitsAgain() const { return course_.again; }

  [[nodiscard]] Answer offer(const TagRead& read, Seconds now);
  /// The UID that was accepted, or confirmed, stands in the site at this place: onwards. In place of siteChanged().
  void registered(std::shared_ptr<const floor::SiteMap> map, const floor::TagUid& uid, Seconds now);
  /// A tag of this tile and what stands at this place take each other's places; when that is done it is registered().
  [[nodiscard]] std::vector<Put> exchange(const floor::TagUid& uid) const;
  /// No tag of this tile is registered any more, to read it from its first place on; when that is done it is cleared().
  [[nodiscard]] std::vector<Put> anew() const;
  void cleared(std::shared_ptr<const floor::SiteMap> map);
  void skip();
  /// To the neighbouring place in the order, registered or not. False: there is none.
  bool next();
  bool previous();
  bool goTo(const PlaceName& place);
  /// Skipped places are to be visited after all.
  void takeUpSkipped();
  void pause() { pace_.pause(); }
  /// What the last step registered; empty: the last step was another.
  [[nodiscard]] const floor::TagUid& justRegistered() const { return last_; }

  /// One step back to where the last tag was registered, exchanged, skipped or its tile cleared. What is to be put into
  /// the site again, nothing after a skip. Where no step is left it goes to the previous place.
  [[nodiscard]] std::vector<Put> back();
  /// What back() gave stands in the site again. In place of siteChanged().
  void restored(std::shared_ptr<const floor::SiteMap> map) { map_ = std::move(map); }

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
    std::size_t stop;  ///< where the walk stood
    struct Tag {
      std::uint32_t tag;
      floor::TagUid before;
      floor::TagUid after;
    };
    std::vector<Tag> tags{};           ///< of that stop's tile; none: it was skipped
    std::vector<std::size_t> taken{};  ///< skipped places that were taken up
  };
  [[nodiscard]] Done doneTo(const floor::Site& now) const;
  [[nodiscard]] bool stands(const Done& done) const;
  Done takeOff();
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
