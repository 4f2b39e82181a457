#include "app/tessera/register_desk.h"

#include "ui/canvas/floor_canvas.h"

namespace tessera::desktop {
namespace {

constexpr double kLeastScale = 150.0;  // pixels per metre from which on a single tag is told from its neighbours
constexpr int kMostZooms = 40;

}  // namespace

RegisterDesk::RegisterDesk(ui::SiteDocument& document, Keeper& keeper, ui::FloorCanvas& canvas)
    : canvas_{canvas},
      notes_{keeper},
      registrar_{std::make_unique<ui::Registrar>(document, bench_, notes_)},
      panel_{new ui::RegisterPanel{*registrar_}},
      tool_{std::make_unique<ui::RegisterTool>(*registrar_, panel_->page())} {
  registrar_->setSounder([this](ui::Registrar::Sound sound) { sounds_.play(sound); });
  connect(registrar_.get(), &ui::Registrar::changed, this, &RegisterDesk::follow);
  connect(panel_, &ui::RegisterPanel::showRequested, this, [this](const scan::PlaceName& place) {
    if (const auto point = tool_->mark(place)) show(*point);
  });
  connect(&keeper, &Keeper::keyChanged, this, [this](const QString& before) {
    if (!before.isEmpty()) notes_.takeFrom(before);
    panel_->setup().refresh();
  });
  // Whoever takes another tool has done for now.
  connect(&canvas_, &ui::FloorCanvas::toolChanged, this, [this](ui::CanvasTool* tool) {
    if (tool != tool_.get()) registrar_->end();
  });
}

RegisterDesk::~RegisterDesk() {
  registrar_->disconnect(this);
  if (canvas_.tool() == tool_.get()) canvas_.setTool(nullptr);
  delete panel_;
}

void RegisterDesk::follow() {
  const auto point = registrar_->point();
  // Who has panned away to look at something is left there until the walk moves on.
  if (!point || point == shown_) {
    if (!point) shown_.reset();
    return;
  }
  shown_ = point;
  show(*point);
}

void RegisterDesk::show(Point place) {
  const ui::View& view = canvas_.view();
  const QSizeF size = view.size();
  const QRectF middle{size.width() / 4, size.height() / 4, size.width() / 2, size.height() / 2};
  if (view.scale() >= kLeastScale && middle.contains(view.toPixel(place))) return;
  canvas_.centreOn(place);
  for (int n = 0; n < kMostZooms && canvas_.view().scale() < kLeastScale; ++n) canvas_.zoomIn();
  canvas_.centreOn(place);
}

}  // namespace tessera::desktop
