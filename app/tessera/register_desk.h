// Registering tags, joined: port and notes behind it, its panel, its tool on the floor, and the floor that follows.
#pragma once

#include <QObject>
#include <QPointer>
#include <memory>

#include "app/tessera/register_notes.h"
#include "app/tessera/scan_sounds.h"
#include "app/tessera/scan_workbench.h"
#include "ui/register/register_panel.h"
#include "ui/register/register_tool.h"

namespace tessera::ui {
class FloorCanvas;
}

namespace tessera::desktop {

class RegisterDesk : public QObject {
  Q_OBJECT
public:
  /// All must outlive it.
  RegisterDesk(ui::SiteDocument& document, Keeper& keeper, ui::FloorCanvas& canvas);
  ~RegisterDesk() override;

  /// To be put into a dock.
  [[nodiscard]] ui::RegisterPanel& panel() { return *panel_; }
  [[nodiscard]] ui::RegisterTool& tool() { return *tool_; }
  [[nodiscard]] ui::Registrar& registrar() { return *registrar_; }

private:
  void follow();
  void show(Point place);

  ui::FloorCanvas& canvas_;
  ScanWorkbench bench_;
  RegisterNotes notes_;
  ScanSounds sounds_;
  std::unique_ptr<ui::Registrar> registrar_;
  QPointer<ui::RegisterPanel> panel_;
  std::unique_ptr<ui::RegisterTool> tool_;
  std::optional<Point> shown_;
};

}  // namespace tessera::desktop
