// What differs between two states of a site, as sentences and as shapes on the floor. Pure, for any thread.
#pragma once

#include <memory>

#include "floor/site_map.h"
#include "sitediff/difference.h"
#include "ui/canvas/change_marks.h"

namespace tessera::ui {

struct Comparison {
  std::shared_ptr<const floor::SiteMap> before;
  std::shared_ptr<const floor::SiteMap> after;
  sitediff::Changes changes;
  /// Without words. The sign with number n belongs to the change with number n.
  ChangeMarks marks;
};

[[nodiscard]] Comparison compare(std::shared_ptr<const floor::SiteMap> before,
                                 std::shared_ptr<const floor::SiteMap> after);

}  // namespace tessera::ui
