#include "ui/base/vehicle_colour.h"

#include <array>

namespace tessera::ui {

QColor vehicleColour(int index, const QPalette& palette) {
  // After Okabe and Ito, without the reds and ambers that mean fault and waiting here; lighter on dark.
  static constexpr std::array<QRgb, 8> kLight{0x0072B2, 0x008B67, 0xB3478F, 0x4B3FA7,
                                              0x2A93C9, 0x7A8B1F, 0x7D5A3C, 0x4A5A6A};
  static constexpr std::array<QRgb, 8> kDark{0x4DA9E8, 0x2CC79A, 0xE58BC4, 0x9C90F2,
                                             0x7FD0F7, 0xBFD04A, 0xCFA27C, 0xA9B8C8};
  const bool dark = palette.color(QPalette::Window).lightness() < 128;
  const auto at = static_cast<std::size_t>(index < 0 ? 0 : index) % kLight.size();
  return QColor::fromRgb(dark ? kDark[at] : kLight[at]);
}

QColor vehicleColour(const floor::Site& site, VehicleId id, const QPalette& palette) {
  int index = 0;
  for (const floor::VehicleSetup& vehicle : site.vehicles) {
    if (vehicle.id == id) return vehicleColour(index, palette);
    ++index;
  }
  return palette.color(QPalette::Disabled, QPalette::WindowText);
}

}  // namespace tessera::ui
