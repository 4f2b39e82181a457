// How the main window finds, measures, imports, exports and prints.
#include "app/tessera/exchange_files.h"
#include "app/tessera/main_window.h"
#include "app/tessera/window_actions.h"
#include "ui/canvas/floor_canvas.h"
#include "ui/find/find_box.h"
#include "ui/find/place_search.h"
#include "ui/measure/measure_tool.h"

namespace tessera::desktop {

void MainWindow::joinLooking() {
  exchange_ = new ExchangeFiles{document_, *this};
  exchange_->setParent(this);
  connect(exchange_, &ExchangeFiles::told, this, &MainWindow::tell);
  measureTool_ = std::make_unique<ui::MeasureTool>();
  find_ = new ui::FindBox{document_, canvas_};
  const auto& a = *actions_;
  connect(a.importFile, &QAction::triggered, exchange_, &ExchangeFiles::importAsking);
  connect(a.exportFile, &QAction::triggered, exchange_, &ExchangeFiles::exportAsking);
  connect(a.mapPicture, &QAction::triggered, this,
          [this] { exchange_->savePictureAsking(canvas_->layers().backdrop); });
  connect(a.find, &QAction::triggered, find_, &ui::FindBox::open);
  connect(find_, &ui::FindBox::chosen, this, [this](const ui::SiteBox& place) {
    canvas_->showPlace(place);
    ui::SiteBox ring = place.grown(-1.0 * ui::kAroundFound);
    ring.add(place.centre());  // of a tag nothing else is left
    canvas_->setRing(ring);
    canvas_->setFocus();
  });
  connect(find_, &ui::FindBox::left, canvas_, [this] { canvas_->setFocus(); });
  connect(a.measure, &QAction::triggered, this, [this] { useTool(measureTool_.get()); });
  connect(measureTool_.get(), &ui::CanvasTool::changed, this, &MainWindow::showTool);
}

}  // namespace tessera::desktop
