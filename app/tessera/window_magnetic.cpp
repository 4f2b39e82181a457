// What vehicles have learned of the iron in the floor, in the main window: a layer of the floor, and an end to it.
#include <QMessageBox>
#include <QPushButton>

#include "app/tessera/magnetic_desk.h"
#include "app/tessera/main_window.h"
#include "app/tessera/window_actions.h"

namespace tessera::desktop {

void MainWindow::joinMagnetic() {
  magnetic_ = std::make_unique<MagneticDesk>(document_, *session_, *keeper_, *canvas_);
  connect(magnetic_.get(), &MagneticDesk::failed, this, &MainWindow::tell);
  const auto offer = [this] { actions_->forgetIron->setEnabled(!magnetic_->map()->empty()); };
  connect(magnetic_.get(), &MagneticDesk::changed, this, offer);
  offer();
  connect(actions_->forgetIron, &QAction::triggered, this, [this] {
    QMessageBox box{QMessageBox::Question, tr("Forget the magnetic map"),
                    tr("Forget what vehicles have learned of the iron in this floor? This cannot be undone; they learn "
                       "it anew as they drive."),
                    QMessageBox::Cancel, this};
    box.setObjectName(QStringLiteral("forgetIronQuestion"));
    const QPushButton* yes = box.addButton(tr("&Forget"), QMessageBox::DestructiveRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    if (box.clickedButton() == yes) magnetic_->forget();
  });
}

}  // namespace tessera::desktop
