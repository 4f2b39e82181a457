#include "ui/canvas/theme.h"

namespace tessera::ui {

CanvasTheme::CanvasTheme(const QPalette& palette)
    : dark{palette.color(QPalette::Window).lightness() < 128}, text{palette.color(QPalette::Text)} {
  const auto pick = [this](QRgb light, QRgb night) { return QColor::fromRgb(dark ? night : light); };
  background = pick(0xDADEE4, 0x1A1D21);
  grid = pick(0xC9CFD7, 0x262B31);
  tile = pick(0xFAFBFC, 0x2B3037);
  seam = pick(0xDCE1E7, 0x3A414A);
  serial = pick(0xA9B2BD, 0x5F6975);
  tag = pick(0x8694A6, 0x77869A);
  missingTag = pick(0xD98B2B, 0xE0A04A);
  quietText = pick(0x5B6673, 0x9AA5B1);
  halo = pick(0xFFFFFF, 0x14171A);
  panel = pick(0xFFFFFF, 0x23272D);
  route = pick(0x7289A8, 0x7D93B2);
  selectedRoute = pick(0x1F5FBF, 0x6FA8FF);
  onRoute = pick(0xFFFFFF, 0x10151C);
  accent = pick(0xD0600A, 0xFF9A3C);
  fault = pick(0xC62828, 0xFF6B60);
  waiting = pick(0xB7791F, 0xF2B632);
  silent = pick(0x8A929B, 0x7B838C);
}

QColor CanvasTheme::zone(floor::ZoneKind kind) const {
  using floor::ZoneKind;
  switch (kind) {
    case ZoneKind::Running:
      return QColor::fromRgb(dark ? 0x8FA3BA : 0x5F7690);
    case ZoneKind::Storage:
      return QColor::fromRgb(dark ? 0xC9A36B : 0x8C6D31);
    case ZoneKind::Parking:
      return QColor::fromRgb(dark ? 0x7FB2F0 : 0x2F6FB5);
    case ZoneKind::Charging:
      return QColor::fromRgb(dark ? 0x55C596 : 0x11805A);
    case ZoneKind::NoGo:
      return QColor::fromRgb(dark ? 0xFF7A6B : 0xC0392B);
    case ZoneKind::Slow:
      return QColor::fromRgb(dark ? 0xF0C04A : 0xA87400);
    case ZoneKind::OneWay:
      return QColor::fromRgb(dark ? 0xC39BEA : 0x7A4FB0);
    case ZoneKind::SingleVehicle:
      return QColor::fromRgb(dark ? 0x5CC7D6 : 0x13798A);
  }
  return quietText;
}

}  // namespace tessera::ui
