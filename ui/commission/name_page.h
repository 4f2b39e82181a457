// What the vehicle is called, and by which number it is called on the radio.
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QWizardPage>

#include "ui/base/notice.h"
#include "ui/commission/commissioning.h"

namespace tessera::ui {

class NamePage : public QWizardPage {
  Q_OBJECT
public:
  explicit NamePage(Commissioning& work, QWidget* parent = nullptr);
  void initializePage() override;
  void cleanupPage() override {}
  [[nodiscard]] bool isComplete() const override;

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslate();
  void take();
  void remark();

  Commissioning& work_;
  bool showing_ = false;
  QLabel nameLabel_;
  QLineEdit name_;
  QLabel addressLabel_;
  QSpinBox address_;
  QLabel hint_;
  Notice notice_;
};

}  // namespace tessera::ui
