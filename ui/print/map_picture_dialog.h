// Asks how the map's picture shall look, shows it, and how large the paper will be.
#pragma once

#include <QDialog>
#include <memory>

#include "floor/site_map.h"
#include "ui/print/map_sheet.h"

class QCheckBox;
class QComboBox;
class QLabel;

namespace tessera::ui {

class MapPictureDialog : public QDialog {
  Q_OBJECT
public:
  /// planShown: the picture of the building is to be seen in the window; otherwise it is left out unless it is wished.
  explicit MapPictureDialog(std::shared_ptr<const floor::SiteMap> map, bool planShown, QWidget* parent = nullptr);

  [[nodiscard]] SheetWish wish() const;

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  void look();

  std::shared_ptr<const floor::SiteMap> map_;
  QComboBox* scale_;
  QCheckBox* tags_;
  QCheckBox* serials_;
  QCheckBox* zones_;
  QCheckBox* routes_;
  QCheckBox* legend_;
  QCheckBox* plan_;
  QLabel* size_;
  QLabel* picture_;
};

}  // namespace tessera::ui
