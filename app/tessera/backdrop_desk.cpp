#include "app/tessera/backdrop_desk.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

#include "app/tessera/wait_cursor.h"
#include "floor/picture.h"
#include "floor/text_file.h"
#include "ui/base/wording.h"
#include "ui/canvas/floor_canvas.h"

namespace tessera::desktop {

BackdropDesk::BackdropDesk(ui::SiteDocument& document, ui::FloorCanvas& canvas, QWidget& window)
    : document_{document},
      canvas_{canvas},
      window_{window},
      tool_{std::make_unique<ui::BackdropTool>(document)},
      panel_{new ui::BackdropPanel{document, *tool_}} {
  connect(panel_, &ui::BackdropPanel::pictureWanted, this, &BackdropDesk::choose);
  connect(panel_, &ui::BackdropPanel::scalingWanted, this, [this] {
    canvas_.setTool(tool_.get());
    tool_->startScaling();
    canvas_.setFocus();
  });
  // What comes next is done on the floor, Esc included.
  connect(panel_, &ui::BackdropPanel::scalingEnded, this, [this] { canvas_.setFocus(); });
}

BackdropDesk::~BackdropDesk() {
  if (canvas_.tool() == tool_.get()) canvas_.setTool(nullptr);
  delete panel_;
}

void BackdropDesk::choose() {
  const QDir folder = document_.path().isEmpty() ? QDir::home() : QFileInfo{document_.path()}.dir();
  const QString path = QFileDialog::getOpenFileName(&window_, tr("Choose a picture of the floor plan"), folder.path(),
                                                    tr("Pictures (*.png *.jpg *.jpeg);;All files (*)"));
  if (!path.isEmpty()) put(path);
}

bool BackdropDesk::put(const QString& path) {
  const bool first = !document_.site().backdrop;
  const auto done = [&]() -> Result<void> {
    const WaitCursor wait;
    auto bytes = floor::loadText(path.toStdString(), floor::kMostPicture + 1);
    if (!bytes) return tl::unexpected{bytes.error()};
    return ui::BackdropEdits{document_}.put(QFileInfo{path}.fileName(), *std::move(bytes));
  }();
  if (!done) {
    tell(ui::text(done.error().sentence));
    return false;
  }
  canvas_.setTool(tool_.get());
  if (first) canvas_.fit();
  canvas_.setFocus();
  return true;
}

void BackdropDesk::tell(const QString& sentence) {
  QMessageBox box{QMessageBox::Warning, tr("The picture could not be taken"), sentence, QMessageBox::Ok, &window_};
  box.setObjectName(QStringLiteral("backdropTrouble"));
  box.exec();
}

}  // namespace tessera::desktop
