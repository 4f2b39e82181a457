// What kind of vehicle: outline, wheels, speed, and where its readers sit. A drawing shows what was typed.
#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QWizardPage>

#include "ui/base/notice.h"
#include "ui/commission/commissioning.h"
#include "ui/commission/reader_table.h"
#include "ui/commission/vehicle_preview.h"

namespace tessera::ui {

class TypePage : public QWizardPage {
  Q_OBJECT
public:
  explicit TypePage(Commissioning& work, QWidget* parent = nullptr);
  void initializePage() override;
  void cleanupPage() override {}
  [[nodiscard]] bool isComplete() const override;

protected:
  void changeEvent(QEvent* event) override;

private:
  struct Field {
    QLabel label;
    QDoubleSpinBox box;
  };
  void layOut();
  void prepare(Field& field, const char* name, double low, double high, double step, int decimals);
  void retranslate();
  void choosePreset(int index);
  void showDraft();
  void takeFields();
  void judge(bool tell);
  [[nodiscard]] QString complaint() const;

  Commissioning& work_;
  bool showing_ = false;
  bool complete_ = false;  ///< as the wizard was told
  QLabel presetLabel_;
  QComboBox preset_;
  Field front_, rear_, width_, track_, wheel_, speed_, turn_, corner_, radius_;
  QLabel readersLabel_;
  ReaderTable readers_;
  VehiclePreview preview_;
  Notice notice_;
};

}  // namespace tessera::ui
