// The picture beneath the floor, joined: its panel, its tool on the floor, and the file that it is read from.
#pragma once

#include <QObject>
#include <QPointer>
#include <memory>

#include "ui/backdrop/backdrop_panel.h"
#include "ui/backdrop/backdrop_tool.h"

namespace tessera::ui {
class FloorCanvas;
}

namespace tessera::desktop {

class BackdropDesk : public QObject {
  Q_OBJECT
public:
  /// All must outlive it.
  BackdropDesk(ui::SiteDocument& document, ui::FloorCanvas& canvas, QWidget& window);
  ~BackdropDesk() override;

  /// To be put into a dock.
  [[nodiscard]] ui::BackdropPanel& panel() { return *panel_; }
  [[nodiscard]] ui::BackdropTool& tool() { return *tool_; }
  /// False: the file holds no picture that can be shown; a box has said why.
  bool put(const QString& path);

private:
  void choose();
  void tell(const QString& sentence);

  ui::SiteDocument& document_;
  ui::FloorCanvas& canvas_;
  QWidget& window_;
  std::unique_ptr<ui::BackdropTool> tool_;
  QPointer<ui::BackdropPanel> panel_;
};

}  // namespace tessera::desktop
