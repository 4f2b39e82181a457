#include "ui/backdrop/backdrop_edits.h"

#include <algorithm>
#include <cmath>

#include "floor/picture.h"
#include "ui/base/tidy.h"
#include "ui/canvas/backdrop_picture.h"

namespace tessera::ui {
namespace {

constexpr qsizetype kLongestFileName = 60;  // in a site file; people know it again
constexpr Metres kFirstPixel{0.01};

bool isPixel(Metres pixel) { return pixel >= floor::kLeastBackdropPixel && pixel <= floor::kMostBackdropPixel; }

}  // namespace

const floor::Backdrop* BackdropEdits::find() const {
  const auto& backdrop = document_.site().backdrop;
  return backdrop ? &*backdrop : nullptr;
}

Result<void> BackdropEdits::put(const QString& file, std::string bytes) {
  const QString shortName = file.size() > kLongestFileName ? file.right(kLongestFileName) : file;
  const std::string name = shortName.toStdString();
  if (bytes.size() > floor::kMostPicture)
    return failure(phrase("Core", "%1 is too large: a picture may have %2 MB. Save it smaller or as JPEG.")
                       .with(name, floor::kMostPicture / 1'000'000));
  if (!floor::isPicture(bytes)) return failure(phrase("Core", "%1 is neither a PNG nor a JPEG picture.").with(name));
  const auto picture = std::make_shared<const std::string>(std::move(bytes));
  if (const auto fault = BackdropPicture::of(picture)->fault())
    return failure(phrase("Core", "%1: %2").with(name, *fault));
  const bool another = find() != nullptr;
  return document_.edit(another ? tr("Another floor plan: %1").arg(shortName) : tr("Add floor plan %1").arg(shortName),
                        [&](floor::Site& site) {
                          if (!site.backdrop) {
                            site.backdrop.emplace();
                            site.backdrop->pixel = kFirstPixel;
                          }
                          site.backdrop->file = name;
                          site.backdrop->picture = picture;
                        });
}

Result<void> BackdropEdits::remove() {
  return document_.edit(tr("Remove floor plan"), [](floor::Site& site) { site.backdrop.reset(); });
}

Result<void> BackdropEdits::move(Point origin, int mergeKey) {
  return change(
      tr("Move floor plan"), [&](floor::Backdrop& b) { b.origin = tidy(origin); }, mergeKey);
}

Result<void> BackdropEdits::turn(Radians turn, int mergeKey) {
  return change(
      tr("Turn floor plan"), [&](floor::Backdrop& b) { b.turn = turn; }, mergeKey);
}

Result<void> BackdropEdits::setPixel(Metres pixel, int mergeKey) {
  if (!isPixel(pixel)) return failure(phrase("Core", "That scale is beyond what a floor plan can have."));
  return change(
      tr("Scale floor plan"), [&](floor::Backdrop& b) { b.pixel = pixel; }, mergeKey);
}

Result<void> BackdropEdits::setOpacity(double opacity, int mergeKey) {
  return change(
      tr("Opacity of floor plan"), [&](floor::Backdrop& b) { b.opacity = std::clamp(opacity, 0.0, 1.0); }, mergeKey);
}

Result<void> BackdropEdits::scale(Point from, Point to, Metres truly) {
  const floor::Backdrop* backdrop = find();
  if (backdrop == nullptr) return {};
  const Metres measured = distance(from, to);
  if (measured <= Metres{} || truly <= Metres{})
    return failure(phrase("Core", "The two points are one. Click two points that lie apart."));
  const double factor = truly / measured;
  const Metres pixel = factor * backdrop->pixel;
  const Point origin = from + factor * (backdrop->origin - from);
  const auto far = [](Metres m) { return abs(m) > kFarthest; };
  if (!isPixel(pixel) || far(origin.x) || far(origin.y))
    return failure(phrase("Core", "That scale is beyond what a floor plan can have."));
  // Not rounded: over a long plan that would be seen.
  return change(tr("Scale floor plan"), [&](floor::Backdrop& b) {
    b.pixel = pixel;
    b.origin = origin;
  });
}

Result<void> BackdropEdits::change(const QString& step, const std::function<void(floor::Backdrop&)>& what,
                                   int mergeKey) {
  if (find() == nullptr) return {};
  return document_.edit(
      step, [&](floor::Site& site) { what(*site.backdrop); }, mergeKey);
}

}  // namespace tessera::ui
