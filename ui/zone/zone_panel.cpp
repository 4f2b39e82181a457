#include "ui/zone/zone_panel.h"

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QIcon>
#include <QLabel>
#include <QPainter>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/base/name_list.h"
#include "ui/base/place_table.h"
#include "ui/base/tidy.h"
#include "ui/base/wording.h"
#include "ui/canvas/theme.h"
#include "ui/zone/zone_shape.h"
#include "ui/zone/zone_words.h"

namespace tessera::ui {
namespace {

constexpr int kFirstValueKey = 32'000'000;  // apart from those of other panels

// The colour that the zone has on the floor.
QIcon swatch(const CanvasTheme& theme, floor::ZoneKind kind, int side) {
  QPixmap picture{side, side};
  picture.fill(Qt::transparent);
  QPainter painter{&picture};
  painter.setRenderHint(QPainter::Antialiasing);
  QColor fill = theme.zone(kind);
  painter.setPen(QPen{fill, 2.0});
  fill.setAlpha(90);
  painter.setBrush(fill);
  painter.drawRoundedRect(QRectF{2, 2, side - 4.0, side - 4.0}, 3, 3);
  return QIcon{picture};
}

}  // namespace

ZonePanel::ZonePanel(SiteDocument& document, Selection& selection, QWidget* parent)
    : QWidget{parent},
      document_{document},
      selection_{selection},
      edits_{document},
      corners_{new CornerModel{document, this}},
      valueKey_{kFirstValueKey} {
  setObjectName("zonePanel");
  makeActions();
  pages_ = new QStackedWidget{this};
  pages_->addWidget(makeEmptyPage());
  pages_->addWidget(makeListPage());
  auto* layout = new QVBoxLayout{this};
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(pages_);
  connect(&document_, &SiteDocument::changed, this, &ZonePanel::refreshList);
  connect(&selection_, &Selection::zoneChanged, this, [this] {
    ++valueKey_;
    refreshList();
  });
  connect(corners_, &CornerModel::refused, this, &ZonePanel::refused);
  retranslate();
  refreshList();
}

void ZonePanel::refreshList() {
  const auto& zones = document_.site().zones;
  QStringList names;
  for (const floor::Zone& zone : zones) names << QString::fromStdString(zone.name);
  const QString now = list_->setNames(names, selection_.zone());
  const CanvasTheme theme{palette()};
  for (int n = 0; n < list_->count(); ++n) {
    const floor::Zone& zone = zones[static_cast<std::size_t>(n)];
    list_->item(n)->setToolTip(
        QStringLiteral("%1, %2").arg(zoneKindName(zone.kind), areaText(squareMetres(zone.outline))));
    list_->item(n)->setIcon(swatch(theme, zone.kind, list_->iconSize().width()));
  }
  pages_->setCurrentIndex(names.isEmpty() ? 0 : 1);
  selection_.setZone(now);
  refreshDetails();
}

void ZonePanel::refreshDetails() {
  const floor::Zone* zone = edits_.find(selection_.zone());
  const auto current = currentCorner();
  filling_ = true;
  corners_->setZone(selection_.zone());
  details_->setEnabled(zone != nullptr);
  for (QAction* action : {rename_, duplicate_, delete_, insertCorner_}) action->setEnabled(zone != nullptr);
  const bool slow = zone != nullptr && zone->kind == floor::ZoneKind::Slow;
  const bool oneWay = zone != nullptr && zone->kind == floor::ZoneKind::OneWay;
  if (zone != nullptr) kind_->setCurrentIndex(static_cast<int>(zone->kind));
  if (slow) speed_->setValue(zone->speed.value_or(MetresPerSecond{}).value());
  if (oneWay) {
    const double turn = std::fmod(degrees(zone->direction.value_or(Radians{})), 360.0);
    direction_->setValue(turn < 0.0 ? turn + 360.0 : turn);
  }
  for (QWidget* widget : {static_cast<QWidget*>(speedLabel_), static_cast<QWidget*>(speed_)}) widget->setVisible(slow);
  for (QWidget* widget : {static_cast<QWidget*>(directionLabel_), static_cast<QWidget*>(direction_)})
    widget->setVisible(oneWay);
  kind_->setToolTip(zone != nullptr ? zoneKindMeaning(zone->kind) + QStringLiteral("\n\n") + zoneStackingRules()
                                    : zoneStackingRules());
  area_->setText(zone != nullptr ? areaText(squareMetres(zone->outline)) : QString{});
  filling_ = false;
  if (current && *current < static_cast<std::size_t>(corners_->rowCount()) && !currentCorner()) setCorner(current);
  deleteCorner_->setEnabled(zone != nullptr && currentCorner() && corners_->rowCount() > 3);
}

void ZonePanel::setCorner(std::optional<std::size_t> corner) {
  if (corner == currentCorner()) return;
  filling_ = true;
  table_->setPlace(corner);
  filling_ = false;
  deleteCorner_->setEnabled(currentCorner() && corners_->rowCount() > 3);
}

std::optional<std::size_t> ZonePanel::currentCorner() const { return table_->place(); }

floor::ZoneKind ZonePanel::kindOfNew() const {
  // As a rule one draws several of a kind in a row; a floor's first zone is the one that vehicles drive in.
  const floor::Zone* zone = edits_.find(selection_.zone());
  return zone != nullptr ? zone->kind : floor::ZoneKind::Running;
}

void ZonePanel::startRenaming() { list_->startRenaming(); }

void ZonePanel::insertCorner() {
  const floor::Zone* zone = edits_.find(selection_.zone());
  if (zone == nullptr || zone->outline.empty()) return;
  const std::vector<Point>& all = zone->outline;
  const std::size_t at = std::min(currentCorner().value_or(all.size() - 1), all.size() - 1);
  const Point next = all[(at + 1) % all.size()];
  if (!tell(edits_.insertCorner(selection_.zone(), at + 1, tidy(all[at] + 0.5 * (next - all[at]))))) return;
  setCorner(at + 1);
  Q_EMIT cornerSelected(at + 1);
}

void ZonePanel::deleteCorner() {
  if (const auto corner = currentCorner()) tell(edits_.removeCorner(selection_.zone(), *corner));
}

void ZonePanel::duplicate() {
  const auto copy = edits_.duplicate(selection_.zone());
  if (!tell(copy)) return;
  selection_.setZone(*copy);
  startRenaming();
}

void ZonePanel::refuse(const Error& why) { Q_EMIT refused(text(why.sentence)); }

void ZonePanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange) {
    retranslate();
    corners_->retranslate();
    refreshList();
  } else if (event->type() == QEvent::PaletteChange && details_ != nullptr) {
    refreshList();
  }
  QWidget::changeEvent(event);
}

}  // namespace tessera::ui
