// The dialogues that the main window opens, and what comes of them.
#include <QStatusBar>

#include "app/tessera/fleet_session.h"
#include "app/tessera/keeper.h"
#include "app/tessera/main_window.h"
#include "app/tessera/radio_workbench.h"
#include "app/tessera/scan_workbench.h"
#include "app/tessera/site_files.h"
#include "app/tessera/window_actions.h"
#include "ui/commission/commission_wizard.h"
#include "ui/connect/connect_dialog.h"
#include "ui/connect/radio_dialog.h"

namespace tessera::desktop {

std::optional<ui::ConnectionChoice> MainWindow::chooseConnection() {
  ui::ConnectDialog dialog{this};
  dialog.setSiteBaud(document_.site().radio.baud);
  dialog.setPorts(portsFound());
  dialog.setChoice(settings_.connection());
  connect(&dialog, &ui::ConnectDialog::refreshRequested, &dialog, [&dialog] { dialog.setPorts(portsFound()); });
  if (dialog.exec() != QDialog::Accepted) return std::nullopt;
  settings_.setConnection(dialog.choice());
  return dialog.choice();
}

void MainWindow::askConnection() {
  if (const auto choice = chooseConnection()) connectTo(*choice);
}

void MainWindow::connectTo(const ui::ConnectionChoice& choice) { session_->connectTo(choice, document_.map()); }

void MainWindow::commission(std::optional<VehicleId> vehicle) {
  ui::CommissionWizard wizard{*session_, document_, vehicle, this};
  commissioning_ = true;
  connect(&wizard, &ui::CommissionWizard::connectRequested, this, &MainWindow::askConnection);
  wizard.setProperty("helpTopic", QStringLiteral("commissioning"));
  connect(&wizard, &QWizard::helpRequested, this, &MainWindow::showHelp);
  connect(&wizard, &ui::CommissionWizard::saveRequested, files_, &SiteFiles::save);
  // A key that is lost takes its vehicle away. So it goes into the file at once where nothing else would go with it
  // that nobody has decided to save, and into the database at once where it would.
  const bool nothingElse = !document_.path().isEmpty() && !document_.isModified();
  const auto keepKey = [this, &wizard, nothingElse] {
    if (!wizard.hasPaired() || !wizard.vehicle()) return;
    if (nothingElse)
      files_->save();
    else
      keeper_->keepNow();
  };
  connect(&wizard, &ui::CommissionWizard::paired, this, keepKey);
  connect(&wizard, &ui::CommissionWizard::siteChanged, this, keepKey);
  wizard.exec();
  commissioning_ = false;
  if (!wizard.vehicle()) return;
  selection_.setVehicle(wizard.vehicle());
  if (wizard.hasPaired() && document_.isModified() && !unasked_)
    files_->offerToSaveKey(QString::fromStdString(wizard.draft().name));
  if (wizard.goesOnCalibrating()) actions_->calibrate->trigger();
}

// A vehicle has taken a key of which an earlier run never heard the end.
void MainWindow::takeUpKeys(const std::vector<supervisor::Event>& events) {
  for (const supervisor::Event& event : events) {
    if (commissioning_ || !event.vehicle || event.kind != supervisor::EventKind::Paired ||
        event.pairing != link::PairingEnd::NewKey)
      continue;
    const auto key = session_->offeredKey(*event.vehicle);
    const bool nothingElse = !document_.path().isEmpty() && !document_.isModified();
    const auto edited = document_.edit(tr("Take up a vehicle's key"), [&](floor::Site& site) {
      for (floor::VehicleSetup& v : site.vehicles)
        if (key && v.id == *event.vehicle) v.key = *key;
    });
    if (!edited || !document_.isModified()) continue;
    if (nothingElse)
      files_->save();
    else
      keeper_->keepNow();
  }
}

void MainWindow::openRadio() {
  const bool live = session_->state() == FleetSession::State::Live;
  const auto choice = live ? session_->choice() : chooseConnection();
  if (!choice) return;
  if (!live && choice->kind == ui::ConnectionChoice::Kind::Demo) {
    tell(tr("The simulated world has no radio module until it is connected: choose Connect first."));
    return;
  }
  RadioWorkbench bench{*session_, *choice, document_.site().radio};
  ui::RadioDialog dialog{bench, document_.site().radio, this};
  dialog.setAdvice(bench.advice());
  connect(&bench, &ui::RadioBench::found, &dialog, [&] { dialog.setAdvice(bench.advice()); });
  dialog.exec();
}

}  // namespace tessera::desktop
