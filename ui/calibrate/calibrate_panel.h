// Readers and wheels calibrated by driving: what to do, how far it is, what was found with its deviations, and the
// button that enters it into the site.
#pragma once

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

#include "ui/calibrate/calibration.h"
#include "ui/calibrate/calibration_panel.h"

namespace tessera::ui {

class CalibratePanel : public CalibrationPanel {
  Q_OBJECT
public:
  /// All must outlive it.
  CalibratePanel(Calibration& work, FleetLink& fleet, Selection& selection, SiteDocument& document,
                 QWidget* parent = nullptr);

Q_SIGNALS:
  /// One sentence: why something was not done.
  void refused(const QString& sentence);

private:
  enum Column { What, Entered, Found, Deviation, Columns };

  void build();
  void retranslate() override;
  void refresh() override;
  void fillTable();
  void setRow(int row, const QString& what, double entered, double found, double deviation, int decimals, bool told);
  void setCell(int row, Column column, const QString& text);
  void record();
  void drawFigure();
  void accept();
  [[nodiscard]] QString name() const;
  [[nodiscard]] QString whatNow() const;
  [[nodiscard]] QString progress() const;
  [[nodiscard]] QString whatIsMissing() const;

  Calibration& work_;
  QLabel* progress_ = nullptr;
  QPushButton* figure_ = nullptr;
  QPushButton* record_ = nullptr;
  QPushButton* reset_ = nullptr;
  QPushButton* accept_ = nullptr;
  QCheckBox* wheels_ = nullptr;
  QLabel* missing_ = nullptr;
  QTableWidget* table_ = nullptr;
};

}  // namespace tessera::ui
