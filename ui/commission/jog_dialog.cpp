#include "ui/commission/jog_dialog.h"

#include <QEvent>
#include <QVBoxLayout>

namespace tessera::ui {

JogDialog::JogDialog(FleetLink& link, Selection& selection, QWidget* parent)
    : QDialog{parent}, link_{link}, selection_{selection}, pad_{link, selection} {
  setObjectName(QStringLiteral("jogDialog"));
  setProperty("helpTopic", QStringLiteral("commissioning"));
  QFont bold = font();
  bold.setBold(true);
  vehicle_.setFont(bold);
  vehicle_.setAlignment(Qt::AlignCenter);
  auto* column = new QVBoxLayout{this};
  column->addWidget(&vehicle_);
  column->addWidget(&pad_, 1);
  setMinimumWidth(fontMetrics().height() * 20);
  pad_.setFocus();
  connect(&link_, &FleetLink::snapshotChanged, this, &JogDialog::nameVehicle);
  connect(&selection_, &Selection::vehicleChanged, this, &JogDialog::nameVehicle);
  retranslate();
}

void JogDialog::nameVehicle() {
  const auto picture = link_.latest();
  const auto id = selection_.vehicle();
  const supervisor::VehicleView* v = picture && id ? picture->find(*id) : nullptr;
  const QString name = v != nullptr ? QString::fromStdString(v->name) : tr("No vehicle");
  if (name != vehicle_.text()) vehicle_.setText(name);
}

void JogDialog::retranslate() {
  setWindowTitle(tr("Drive by hand"));
  nameVehicle();
}

void JogDialog::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QDialog::changeEvent(event);
}

}  // namespace tessera::ui
