// What was done and what was not, in plain words, before the wizard ends; and the way on to the calibration of readers
// and wheels, which is a drive and so needs the window.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWizardPage>

#include "ui/base/notice.h"
#include "ui/commission/commissioning.h"

namespace tessera::ui {

class SummaryPage : public QWizardPage {
  Q_OBJECT
public:
  explicit SummaryPage(Commissioning& work, QWidget* parent = nullptr);
  void initializePage() override { retranslate(); }
  void cleanupPage() override {}
  [[nodiscard]] static QString nameOf(Commissioning::Step step);
  [[nodiscard]] static QString nameOf(Commissioning::Mark mark);

Q_SIGNALS:
  /// Finish, and go on with readers and wheels.
  void calibrateRequested();

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslate();

  Commissioning& work_;
  QLabel list_;
  Notice notice_;
  QLabel next_;
  QPushButton calibrate_;
};

}  // namespace tessera::ui
