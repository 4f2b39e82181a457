// The key that vehicle and site share: the vehicle obeys nobody who does not have it.
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>

#include "ui/commission/pairing.h"
#include "ui/commission/step_page.h"

namespace tessera::ui {

class KeyPage : public StepPage {
  Q_OBJECT
public:
  explicit KeyPage(Commissioning& work, QWidget* parent = nullptr);
  void initializePage() override;

Q_SIGNALS:
  /// The site's file does not have the vehicle's new key yet.
  void saveRequested();

protected:
  void retranslate() override;
  void refresh(const supervisor::VehicleView* vehicle) override;
  void hideEvent(QHideEvent* event) override;

private:
  void pair();
  void useTypedKey();
  void showKind();
  void showKey();
  void showWhetherSaved();

  Pairing pairing_;
  QLabel why_;
  QRadioButton pairKind_;
  QLabel pairHint_;
  QPushButton pair_;
  QRadioButton knownKind_;
  QLineEdit typed_;
  QPushButton use_;
  QLabel keyLabel_;
  QLineEdit key_;
  QPushButton reveal_;
  QPushButton copy_;
  Notice result_;
  Notice unsaved_;
  QPushButton save_;
};

}  // namespace tessera::ui
