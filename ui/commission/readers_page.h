// Does each reader read? A light for each when a tag comes under it, and the tags' numbers as they come.
#pragma once

#include <QLabel>
#include <QTableWidget>

#include "ui/commission/step_page.h"
#include "ui/commission/vehicle_preview.h"

namespace tessera::ui {

class ReadersPage : public StepPage {
  Q_OBJECT
public:
  explicit ReadersPage(Commissioning& work, QWidget* parent = nullptr);
  void initializePage() override;

protected:
  void retranslate() override;
  void refresh(const supervisor::VehicleView* vehicle) override;

private:
  void fill(const supervisor::VehicleView* vehicle);

  std::optional<Seconds> since_;  ///< only tags read after the page was opened count
  unsigned seen_ = 0;             ///< bit i: reader i has read one since
  QLabel hint_;
  QTableWidget table_;
  VehiclePreview preview_;
  Notice result_;
};

}  // namespace tessera::ui
