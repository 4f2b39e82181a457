#include "ui/print/map_sheet.h"

#include <QApplication>
#include <QFontMetricsF>
#include <QLocale>
#include <QPalette>
#include <algorithm>
#include <set>

#include "ui/canvas/floor_painter.h"
#include "ui/canvas/furniture.h"
#include "ui/canvas/route_painter.h"
#include "ui/canvas/view.h"

namespace tessera::ui {
namespace {

constexpr double kEdge = 24.0;
constexpr double kLeastWidth = 420.0;
constexpr Metres kAround{0.3};
constexpr double kNarrowestSerial = 30.0;
constexpr double kDotsPerUnitOfPlan = 300.0 / 96.0;  // of a picture on paper the eye sees no more

class SheetText {
  Q_DECLARE_TR_FUNCTIONS(MapSheet)
public:
  static QString scale(double scale) { return tr("Scale 1 : %1").arg(QLocale().toString(scale, 'g', 6)); }
  static QString tag() { return tr("Tag"); }
  static QString missing() { return tr("Place without a registered tag"); }
  static QString route() { return tr("Route"); }
  static QString north() { return tr("N", "north"); }
  static QString unnamed() { return tr("Unnamed site"); }
  static QString zone(floor::ZoneKind kind) {
    switch (kind) {
      case floor::ZoneKind::Running:
        return tr("Running zone");
      case floor::ZoneKind::Storage:
        return tr("Storage");
      case floor::ZoneKind::Parking:
        return tr("Parking");
      case floor::ZoneKind::Charging:
        return tr("Charging");
      case floor::ZoneKind::NoGo:
        return tr("No-go zone");
      case floor::ZoneKind::Slow:
        return tr("Slow zone");
      case floor::ZoneKind::OneWay:
        return tr("One-way zone");
      case floor::ZoneKind::SingleVehicle:
        return tr("Zone for one vehicle at a time");
    }
    return {};
  }
};

// Paper is white, whatever the window looks like.
CanvasTheme paper() {
  QPalette palette;
  palette.setColor(QPalette::Window, Qt::white);
  palette.setColor(QPalette::Base, Qt::white);
  palette.setColor(QPalette::WindowText, Qt::black);
  palette.setColor(QPalette::Text, Qt::black);
  return CanvasTheme{palette};
}

// In points, as what paints zones and routes reckons with them; the painters' devices have 96 dots per inch.
QFont sheetFont(double points = 9.75) {
  QFont font = QApplication::font();
  font.setPointSizeF(points);
  return font;
}

std::set<floor::ZoneKind> kindsOf(const floor::Site& site) {
  std::set<floor::ZoneKind> kinds;
  for (const floor::Zone& zone : site.zones) kinds.insert(zone.kind);
  return kinds;
}

}  // namespace

MapSheet::MapSheet(std::shared_ptr<const floor::SiteMap> map, const SheetWish& wish)
    : map_{std::move(map)}, wish_{wish}, index_{map_->site()}, line_{QFontMetricsF{sheetFont()}.height() * 1.25} {
  shown_ = index_.box();
  const floor::Site& site = map_->site();
  for (const floor::Zone& zone : site.zones)
    for (const Point& p : zone.outline) shown_.add(p);
  for (const floor::Route& route : site.routes)
    for (const Point& p : route.vertices) shown_.add(p);
  if (wish_.plan && site.backdrop) plan_ = BackdropPicture::of(site.backdrop->picture);
  if (plan_ && plan_->fault()) plan_.reset();
  if (plan_)
    for (const Point& p : cornersOf(*site.backdrop, plan_->size())) shown_.add(p);
  if (shown_.empty()) shown_.add(Point{});
  shown_ = shown_.grown(kAround);
  const double perMetre = 1000.0 / wish_.scale * kUnitsPerMm;
  // The name of a running zone stands above it.
  const bool namesAbove = wish_.zones && kindsOf(site).contains(floor::ZoneKind::Running);
  above_ = (namesAbove ? 3.75 : 2.5) * line_;
  const double below = wish_.legend ? (legendRows() + 0.5) * line_ : 0.0;
  size_ = {std::max(kLeastWidth, shown_.width().value() * perMetre + 2 * kEdge),
           shown_.height().value() * perMetre + 2 * kEdge + above_ + below};
}

bool MapSheet::hasRoomForSerials() const {
  const double perMetre = 1000.0 / wish_.scale * kUnitsPerMm;
  const auto& tiles = index_.tiles();
  return std::any_of(tiles.begin(), tiles.end(), [&](const FloorIndex::Tile& tile) {
    return tile.box.width().value() * perMetre >= kNarrowestSerial;
  });
}

std::size_t MapSheet::places() const {
  std::size_t count = index_.tiles().size() + index_.loose().size();
  if (wish_.tags)
    for (const FloorIndex::Tile& tile : index_.tiles()) count += index_.offsetsOf(tile.shape).size();
  return count;
}

void MapSheet::paint(QPainter& painter) const {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(sheetFont());
  painter.fillRect(QRectF{{}, size_}, Qt::white);
  paintTitle(painter);
  const double below = wish_.legend ? (legendRows() + 0.5) * line_ : 0.0;
  const QRectF area{kEdge, kEdge + above_, size_.width() - 2 * kEdge, size_.height() - 2 * kEdge - above_ - below};
  paintFloor(painter, area);
  if (wish_.legend) paintLegend(painter, {area.left(), area.bottom() + 0.5 * line_, area.width(), below});
}

void MapSheet::paintTitle(QPainter& painter) const {
  QFont large = sheetFont(13.5);
  large.setBold(true);
  painter.setPen(Qt::black);
  painter.setFont(large);
  const QString name = QString::fromStdString(map_->site().name);
  const double width = size_.width() - 2 * kEdge;
  painter.drawText(
      QPointF{kEdge, kEdge + 0.9 * line_},
      QFontMetricsF{large}.elidedText(name.isEmpty() ? SheetText::unnamed() : name, Qt::ElideRight, width));
  painter.setFont(sheetFont());
  QString second = SheetText::scale(wish_.scale);
  if (!wish_.date.isEmpty()) second += QStringLiteral("  ·  ") + wish_.date;
  painter.drawText(QPointF{kEdge, kEdge + 2.0 * line_}, second);
}

void MapSheet::paintFloor(QPainter& painter, const QRectF& area) const {
  View view{area.size(), 1.0};
  view.setScale(1000.0 / wish_.scale * kUnitsPerMm);
  view.centreOn(shown_.centre());
  const CanvasTheme theme = paper();
  painter.save();
  painter.translate(area.topLeft());
  if (plan_) paintPlan(painter, view, {{}, area.size()});
  paintTiles(painter, view, theme);
  if (wish_.zones) paintZones(painter, view, map_->site().zones, theme);
  if (wish_.routes)
    for (const floor::Route& route : map_->site().routes) paintRoute(painter, view, theme, route, RouteLook::Quiet);
  painter.restore();
}

void MapSheet::paintPlan(QPainter& painter, const View& view, const QRectF& area) const {
  View fine{view.size(), kDotsPerUnitOfPlan};
  fine.setScale(view.scale());
  fine.centreOn(view.centre());
  paintBackdrop(painter, fine, *map_->site().backdrop, *plan_, area);
}

void MapSheet::paintTiles(QPainter& painter, const View& view, const CanvasTheme& theme) const {
  const double radius = std::max(view.scale() * 0.015, 0.5);
  const QFont small = sheetFont(6.75);
  const QFontMetricsF metrics{small};
  const auto tag = [&](Point place, bool registered) {
    painter.setPen(registered ? QPen{Qt::NoPen} : QPen{theme.missingTag, 0.6});
    painter.setBrush(registered ? QBrush{theme.tag} : QBrush{Qt::NoBrush});
    painter.drawEllipse(view.toPixel(place), radius, radius);
  };
  for (const FloorIndex::Tile& tile : index_.tiles()) {
    const QRectF rect = QRectF{view.toPixel(tile.box.low), view.toPixel(tile.box.high)}.normalized();
    painter.setPen(QPen{QColor{150, 158, 168}, 0.5});  // darker than on a screen
    painter.setBrush(theme.tile);
    painter.drawRect(rect);
    if (wish_.tags) {
      const std::vector<Offset>& offsets = index_.offsetsOf(tile.shape);
      for (std::size_t n = 0; n < offsets.size(); ++n)
        tag(tile.origin + offsets[n], index_.isRegistered(tile.firstPlace + n));
    }
    if (!wish_.serials || rect.width() < kNarrowestSerial) continue;
    painter.setFont(small);
    painter.setPen(theme.serial);
    painter.drawText(
        QPointF{rect.left() + 2, rect.bottom() - metrics.descent() - 1},
        metrics.elidedText(QString::fromStdString(index_.serial(tile)), Qt::ElideMiddle, rect.width() - 4));
  }
  painter.setFont(sheetFont());
  if (wish_.tags)
    for (const FloorIndex::Loose& loose : index_.loose()) tag(loose.place, true);
}

int MapSheet::legendRows() const {
  return 2 + (wish_.tags ? 2 : 0) + (wish_.routes && !map_->site().routes.empty() ? 1 : 0) +
         (wish_.zones ? static_cast<int>(kindsOf(map_->site()).size()) : 0);
}

void MapSheet::paintLegend(QPainter& painter, const QRectF& area) const {
  const CanvasTheme theme = paper();
  double y = area.top() + 0.5 * line_;
  const double symbol = 34.0;
  const auto row = [&](const QString& text, const auto& paintSymbol) {
    painter.save();
    paintSymbol(QRectF{area.left(), y - 0.35 * line_, symbol, 0.7 * line_});
    painter.restore();
    painter.setPen(Qt::black);
    painter.drawText(QPointF{area.left() + symbol + 10, y + 0.3 * line_}, text);
    y += line_;
  };
  const double perMetre = 1000.0 / wish_.scale * kUnitsPerMm;
  const Metres bar = niceLength(perMetre, 60.0);
  painter.fillRect(QRectF{area.left(), y - 2, perMetre * bar.value(), 4}, Qt::black);
  painter.setPen(Qt::black);
  painter.drawText(QPointF{area.left() + perMetre * bar.value() + 10, y + 0.3 * line_}, lengthText(bar));
  y += line_;
  row(SheetText::north(), [&](const QRectF& r) {
    painter.translate(r.center());
    painter.rotate(-degrees(map_->site().northToY));
    painter.setBrush(Qt::black);
    painter.drawPolygon(QPolygonF{{0, -9}, {5, 8}, {0, 4}, {-5, 8}});
  });
  if (wish_.tags) {
    row(SheetText::tag(), [&](const QRectF& r) {
      painter.setPen(Qt::NoPen);
      painter.setBrush(theme.tag);
      painter.drawEllipse(r.center(), 4, 4);
    });
    row(SheetText::missing(), [&](const QRectF& r) {
      painter.setPen(QPen{theme.missingTag, 1.2});
      painter.setBrush(Qt::NoBrush);
      painter.drawEllipse(r.center(), 4, 4);
    });
  }
  if (wish_.routes && !map_->site().routes.empty())
    row(SheetText::route(), [&](const QRectF& r) {
      painter.setPen(QPen{theme.route, 2});
      painter.drawLine(QPointF{r.left(), r.center().y()}, QPointF{r.right(), r.center().y()});
    });
  if (!wish_.zones) return;
  for (const floor::ZoneKind kind : kindsOf(map_->site()))
    row(SheetText::zone(kind), [&](const QRectF& r) {
      QColor fill = theme.zone(kind);
      painter.setPen(QPen{fill, 1.5});
      fill.setAlpha(70);
      painter.setBrush(fill);
      painter.drawRect(r);
    });
}

}  // namespace tessera::ui
