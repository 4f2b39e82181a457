// A page of the wizard that is one step of the commissioning: it is done, or skipped by the person's own word. A step
// that needs the vehicle says why it cannot be reached, and offers to connect.
#pragma once

#include <QCheckBox>
#include <QPushButton>
#include <QVBoxLayout>
#include <QWizardPage>

#include "ui/base/notice.h"
#include "ui/commission/commissioning.h"

namespace tessera::ui {

class StepPage : public QWizardPage {
  Q_OBJECT
public:
  enum class Needs { Nothing, Vehicle };

  StepPage(Commissioning& work, Commissioning::Step step, Needs needs, QWidget* parent = nullptr);
  [[nodiscard]] bool isComplete() const override;
  void initializePage() override;
  void cleanupPage() override {}  // what was done stays done on the way back
  /// One sentence that says what must not be cut short by closing the wizard now; empty: nothing.
  [[nodiscard]] virtual QString holdsOpen() const { return {}; }

Q_SIGNALS:
  void connectRequested();

protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  /// The part between the notice and the check box.
  [[nodiscard]] QVBoxLayout& content() { return content_; }
  [[nodiscard]] Commissioning& work() const { return work_; }
  void markDone(bool done = true);

  /// Texts; call the base's too.
  virtual void retranslate();
  /// Shows what the vehicle tells; only called while the page is looked at. vehicle: null when it cannot be reached.
  virtual void refresh(const supervisor::VehicleView* vehicle) { (void)vehicle; }

private:
  void look();

  Commissioning& work_;
  Commissioning::Step step_;
  Needs needs_;
  Notice silence_;
  QPushButton connect_;
  QVBoxLayout& content_;
  QCheckBox skip_;
};

}  // namespace tessera::ui
