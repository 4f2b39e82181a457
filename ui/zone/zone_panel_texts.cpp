// The words of the zone panel, set again whenever the language changes.
#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QPushButton>

#include "ui/base/name_list.h"
#include "ui/base/place_table.h"
#include "ui/zone/zone_panel.h"
#include "ui/zone/zone_words.h"

namespace tessera::ui {

void ZonePanel::nameActions() {
  const auto name = [](QAction* action, const QString& text, const QString& tip) {
    action->setText(text);
    action->setToolTip(action->shortcut().isEmpty()
                           ? tip
                           : QStringLiteral("%1 (%2)").arg(tip, action->shortcut().toString(QKeySequence::NativeText)));
  };
  name(draw_, tr("&New zone"),
       tr("Draw another zone of the chosen one's kind on the floor; the arrow: of another kind"));
  name(rename_, tr("Re&name"), tr("Rename the zone"));
  name(duplicate_, tr("D&uplicate"), tr("Make another zone of the same shape"));
  name(delete_, tr("&Delete zone"), tr("Delete the zone"));
  name(insertCorner_, tr("&Insert corner"), tr("Insert a corner after the chosen one"));
  name(deleteCorner_, tr("Delete &corner"), tr("Delete the chosen corner"));
  const auto kinds = draw_->menu()->actions();
  for (qsizetype n = 0; n < kinds.size(); ++n) {
    const floor::ZoneKind kind = kZoneKinds.at(static_cast<std::size_t>(n));
    kinds[n]->setText(zoneKindName(kind));
    kind_->setItemText(static_cast<int>(n), zoneKindName(kind));
    kind_->setItemData(static_cast<int>(n), zoneKindMeaning(kind), Qt::ToolTipRole);
  }
}

void ZonePanel::retranslate() {
  emptyText_->setText(
      tr("This site has no zone yet. A running zone says where vehicles may drive, other kinds restrict them: drag a "
         "rectangle on the floor, or click the corners."));
  emptyButton_->setText(tr("Draw a &zone"));
  nameActions();
  list_->setAccessibleName(tr("Zones"));
  table_->setAccessibleName(tr("Corners of the zone"));
  kindLabel_->setText(tr("Kind"));
  speedLabel_->setText(tr("Highest speed"));
  speed_->setSuffix(tr(" m/s"));
  directionLabel_->setText(tr("Direction"));
  direction_->setSuffix(tr("°"));
  direction_->setToolTip(tr("Counter-clockwise from x: 0° leads to the right, 90° upwards"));
  areaLabel_->setText(tr("Area"));
}

}  // namespace tessera::ui
