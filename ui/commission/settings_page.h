// The measures of the type, written into the vehicle: what stands in the site beside what the vehicle holds.
#pragma once

#include <QPushButton>
#include <QTableWidget>
#include <optional>
#include <vector>

#include "ui/base/ask_series.h"
#include "ui/commission/step_page.h"
#include "wire/parameters.h"

namespace tessera::ui {

/// What a vehicle must hold to drive as the site says, in the wire's units.
struct WantedSetting {
  wire::Parameter parameter;
  std::int32_t value;
};
[[nodiscard]] std::vector<WantedSetting> wantedSettings(const floor::VehicleSetup& setup);

class SettingsPage : public StepPage {
  Q_OBJECT
public:
  explicit SettingsPage(Commissioning& work, QWidget* parent = nullptr);
  void initializePage() override;

protected:
  void retranslate() override;
  void refresh(const supervisor::VehicleView* vehicle) override;
  void hideEvent(QHideEvent* event) override;

private:
  void ask(wire::MessageType type);
  void fill();
  void showAnswer(std::size_t index, const supervisor::AskAnswer& answer);
  void finish();
  [[nodiscard]] bool allRight() const;

  AskSeries series_;
  std::vector<WantedSetting> wanted_;
  std::vector<std::optional<std::int32_t>> held_;
  bool reachable_ = false;
  bool askedOnce_ = false;
  QTableWidget table_;
  QPushButton read_;
  QPushButton write_;
  Notice result_;
};

}  // namespace tessera::ui
