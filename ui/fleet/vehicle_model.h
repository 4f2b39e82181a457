// The site's vehicles as rows. Keeps of each what is shown, rounded as it is shown, so that a picture of the fleet
// costs signals and painting only where a reader would see a difference.
#pragma once

#include <QAbstractTableModel>
#include <QPalette>
#include <array>
#include <memory>
#include <vector>

#include "supervisor/snapshot.h"
#include "ui/base/site_document.h"
#include "ui/fleet/condition.h"
#include "ui/fleet/roles.h"

namespace tessera::ui {

class VehicleModel : public QAbstractTableModel {
  Q_OBJECT
public:
  enum Column { Name, State, Progress, RouteName, Speed, Battery, Link, Age, Place, ColumnCount };

  explicit VehicleModel(SiteDocument& document, QObject* parent = nullptr);

  /// May be null: nothing is known.
  void setSnapshot(std::shared_ptr<const supervisor::Snapshot> snapshot);
  void setPalette(const QPalette& palette);
  [[nodiscard]] int rowOf(VehicleId id) const;  ///< -1: no such vehicle
  [[nodiscard]] VehicleId idAt(int row) const { return rows_.at(static_cast<std::size_t>(row)).id; }
  [[nodiscard]] const supervisor::VehicleView* viewOf(VehicleId id) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  /// Every text anew, after the language or the palette changed.
  void refreshTexts();

private:
  static constexpr int kUnknown = -1;
  struct Row {
    VehicleId id;
    QString name;
    Condition condition = Condition::NoPort;
    std::string route;
    std::uint16_t faults = 0;
    int permille = kUnknown;
    int speed = kUnknown;        ///< cm/s, without its sign
    int battery = kUnknown;      ///< 0.1 V
    int loss = kUnknown;         ///< %
    int age = kUnknown;          ///< 0.1 s
    int uncertainty = kUnknown;  ///< mm
  };

  void takeSite();
  [[nodiscard]] Row rowFor(const Row& old, const supervisor::VehicleView* view) const;
  void put(int row, const Row& fresh);
  [[nodiscard]] QVariant shown(const Row& row, int column) const;
  [[nodiscard]] QVariant sortKey(const Row& row, int column) const;
  [[nodiscard]] QString iconOf(const Row& row, int column) const;
  [[nodiscard]] static Tone toneFor(const Row& row, int column);
  [[nodiscard]] QString tip(const Row& row, int column) const;

  SiteDocument& document_;
  std::shared_ptr<const supervisor::Snapshot> snapshot_;
  QPalette palette_;
  std::vector<Row> rows_;
};

}  // namespace tessera::ui
