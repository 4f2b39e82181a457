// Regions made wider, narrower, and carried along.
#include "region/clipper_bridge.h"

namespace tessera::region {

namespace cl = ClipperLib;

Region Region::grown(Metres by) const {
  if (empty()) return {};
  cl::ClipperOffset offset;
  offset.AddPaths(ClipperBridge::pathsOf(*this), cl::jtMiter, cl::etClosedPolygon);
  cl::Paths result;
  offset.Execute(result, by.value() * 1e6);
  return ClipperBridge::regionOf(result);
}

Region Region::opened(Metres width) const { return grown(-0.5 * width).grown(0.5 * width); }

Region Region::swept(Offset way) const {
  const Node by = nodeOf({way.x, way.y});
  if (empty() || by == Node{}) return *this;
  // The outline at both ends, and for each edge the parallelogram between its places.
  cl::Paths all = ClipperBridge::pathsOf(*this);
  for (const Ring& ring : rings_) {
    cl::Path end;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Node a = ring[i];
      const Node b = ring[(i + 1) % ring.size()];
      end.emplace_back(a.x + by.x, a.y + by.y);
      cl::Path side{{a.x, a.y}, {b.x, b.y}, {b.x + by.x, b.y + by.y}, {a.x + by.x, a.y + by.y}};
      if (!cl::Orientation(side)) cl::ReversePath(side);
      all.push_back(std::move(side));
    }
    all.push_back(std::move(end));
  }
  return ClipperBridge::clip(cl::ctUnion, all, {}, cl::pftNonZero);
}

}  // namespace tessera::region
