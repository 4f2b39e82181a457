#include "ui/commission/contact_page.h"

#include <QLocale>
#include <bit>

#include "ui/base/wording.h"

namespace tessera::ui {

ContactPage::ContactPage(Commissioning& work, QWidget* parent)
    : StepPage{work, Commissioning::Step::Contact, Needs::Vehicle, parent} {
  result_.setObjectName(QStringLiteral("contactResult"));
  auto* form = new QFormLayout;
  for (Line& line : lines_) {
    line.value.setTextInteractionFlags(Qt::TextSelectableByMouse);
    line.value.setWordWrap(true);
    form->addRow(&line.name, &line.value);
  }
  lines_[kFirmware].value.setObjectName(QStringLiteral("contactFirmware"));
  content().addLayout(form);
  content().addWidget(&result_);
  content().addStretch();
}

void ContactPage::refresh(const supervisor::VehicleView* v) {
  for (Line& line : lines_) line.value.setText(tr("–", "no value"));
  markDone(v != nullptr);
  if (v == nullptr) {
    result_.clear();
    return;
  }
  const QLocale locale;
  const int wanted = static_cast<int>(work().draft().readers.size());
  const int answering = std::popcount(v->readersAnswering);
  lines_[kFirmware].value.setText(text(v->firmware));
  lines_[kReaders].value.setText(tr("%1 of %2 answer").arg(answering).arg(wanted));
  lines_[kBattery].value.setText(tr("%1 V").arg(locale.toString(v->batteryVolts, 'f', 1)));
  lines_[kLastHeard].value.setText(tr("%1 s ago").arg(locale.toString(v->link.age.value(), 'f', 1)));
  lines_[kRoundTrip].value.setText(tr("%1 ms").arg(locale.toString(v->link.roundTrip.value() * 1000, 'f', 0)));
  lines_[kLoss].value.setText(tr("%1 %").arg(locale.toString(v->link.loss * 100, 'f', 0)));
  const QStringList faults = faultTexts(v->faults);
  lines_[kFaults].value.setText(faults.isEmpty() ? tr("none") : faults.join(tr(", ", "between faults")));
  const QString name = QString::fromStdString(v->name);
  if (v->link.loss > 0.2)
    result_.show(
        Notice::Tone::Warning,
        tr("%1 is in contact, but many answers are lost. Check the antennas, the distance, and whether another "
           "transmitter uses this channel.")
            .arg(name));
  else
    result_.show(Notice::Tone::Good, tr("%1 is in contact and bears the site's key.").arg(name));
}

void ContactPage::retranslate() {
  setTitle(tr("Contact over the air"));
  setSubTitle(tr("Switch the vehicle on. It is called every few seconds until it answers."));
  const std::array<QString, kRows> names{tr("Firmware:"),   tr("Readers:"),      tr("Battery:"), tr("Last heard:"),
                                         tr("Round trip:"), tr("Lost answers:"), tr("Faults:")};
  for (std::size_t i = 0; i < names.size(); ++i) lines_[i].name.setText(names[i]);
  StepPage::retranslate();
}

}  // namespace tessera::ui
