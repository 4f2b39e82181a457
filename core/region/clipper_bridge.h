// Between Region and Clipper; included by this folder's sources alone.
#pragma once

#include <polyclipping/clipper.hpp>

#include "region/region.h"

namespace tessera::region {

struct ClipperBridge {
  [[nodiscard]] static ClipperLib::Path pathOf(const Ring& ring);
  [[nodiscard]] static ClipperLib::Paths pathsOf(const Region& region);
  [[nodiscard]] static Region regionOf(const ClipperLib::Paths& paths);
  [[nodiscard]] static Region clip(ClipperLib::ClipType how, const ClipperLib::Paths& subjects,
                                   const ClipperLib::Paths& clips, ClipperLib::PolyFillType fill);
};

}  // namespace tessera::region
