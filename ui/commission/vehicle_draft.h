// What the wizard knows of vehicles without asking anybody: usual types, free names and addresses, outlines, keys as
// text.
#pragma once

#include <QCoreApplication>
#include <QString>
#include <optional>
#include <vector>

#include "floor/site.h"

namespace tessera::ui {

/// How far the outline reaches from the middle between the driven wheels.
struct VehicleExtent {
  Metres front;
  Metres rear;
  Metres side;
  bool operator==(const VehicleExtent&) const = default;
};

struct VehiclePreset {
  QString name;
  floor::VehicleSetup setup;
};

class VehicleDraft {
  Q_DECLARE_TR_FUNCTIONS(tessera::ui::VehicleDraft)
public:
  [[nodiscard]] static VehicleExtent extentOf(const std::vector<Point>& footprint);
  [[nodiscard]] static std::vector<Point> outlineOf(const VehicleExtent& extent);
  /// Readers in a row across the vehicle, from its left to its right.
  [[nodiscard]] static std::vector<Offset> readerRow(int count, Metres ahead, Metres width);
  /// The usual types, then the site's own vehicles to copy from.
  [[nodiscard]] static std::vector<VehiclePreset> presets(const floor::Site& site);

  /// The lowest that no vehicle of the site has; nullopt: all are taken.
  [[nodiscard]] static std::optional<VehicleId> freeAddress(const floor::Site& site);
  /// "AGV 3": one that no vehicle of the site has.
  [[nodiscard]] static QString freeName(const floor::Site& site, VehicleId address);
  /// One sentence that says why the site cannot have it beside the others; empty: it can. `except`: the vehicle that
  /// it takes the place of.
  [[nodiscard]] static QString complaint(const floor::Site& site, const floor::VehicleSetup& draft,
                                         std::optional<VehicleId> except);

  [[nodiscard]] static wire::Key randomKey();
  /// 32 hexadecimal digits, also in groups; nullopt: something else.
  [[nodiscard]] static std::optional<wire::Key> keyFromText(const QString& text);
  /// "284A 27C7 …"
  [[nodiscard]] static QString keyText(const wire::Key& key);
};

}  // namespace tessera::ui
