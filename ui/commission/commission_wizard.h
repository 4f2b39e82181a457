// Sets a vehicle up, from its measures to its first drive, or changes one that stands in the site.
#pragma once

#include <QLabel>
#include <QWizard>
#include <optional>

#include "ui/commission/commissioning.h"

namespace tessera::ui {

class CommissionWizard : public QWizard {
  Q_OBJECT
public:
  enum Page { kType, kName, kFirmware, kKey, kContact, kSettings, kReaders, kCompass, kJog, kDrive, kSummary, kPages };

  /// editing: a vehicle of the site to change; nullopt: a new one.
  CommissionWizard(FleetLink& link, SiteDocument& document, std::optional<VehicleId> editing = std::nullopt,
                   QWidget* parent = nullptr);

  /// The vehicle that was set up or changed; nullopt: none, or given up.
  [[nodiscard]] std::optional<VehicleId> vehicle() const { return work_.standing(); }
  /// As far as it is known by now.
  [[nodiscard]] const floor::VehicleSetup& draft() const { return work_.draft(); }
  /// The vehicle has taken a new key in this wizard.
  [[nodiscard]] bool hasPaired() const { return work_.paired(); }
  /// The person wants to go on with the calibration of its readers and wheels.
  [[nodiscard]] bool goesOnCalibrating() const { return goesOnCalibrating_; }
  /// Refuse with a sentence while a page must not be cut short; Escape and the window's own button come here as well.
  void accept() override;
  void reject() override;
  bool validateCurrentPage() override;

Q_SIGNALS:
  /// A page needs the vehicles: show the connection dialogue, or connect again.
  void connectRequested();
  /// The site has other vehicles than before: supervision must begin anew with it.
  void siteChanged();
  /// The vehicle has taken a key that nobody knows but this site.
  void paired();
  /// The person wants the site saved now.
  void saveRequested();

protected:
  void changeEvent(QEvent* event) override;

private:
  [[nodiscard]] bool mayClose();
  void retranslate();
  void showSteps();
  [[nodiscard]] QString shortName(Page page) const;

  Commissioning work_;
  QLabel steps_;
  bool goesOnCalibrating_ = false;
};

}  // namespace tessera::ui
