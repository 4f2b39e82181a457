// The panel of registering: choosing first, then place after place.
#pragma once

#include <QStackedWidget>

#include "ui/register/scan_page.h"
#include "ui/register/setup_page.h"

namespace tessera::ui {

class RegisterPanel : public QStackedWidget {
  Q_OBJECT
public:
  explicit RegisterPanel(Registrar& registrar, QWidget* parent = nullptr);

  [[nodiscard]] SetupPage& setup() { return *setup_; }
  [[nodiscard]] ScanPage& page() { return *page_; }

Q_SIGNALS:
  /// A registered tag is to be seen on the floor.
  void showRequested(const tessera::scan::PlaceName& place);

protected:
  void changeEvent(QEvent* event) override;

private:
  void showState();

  Registrar& registrar_;
  SetupPage* setup_;
  ScanPage* page_;
};

}  // namespace tessera::ui
