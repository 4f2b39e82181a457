#include "ui/commission/name_page.h"

#include <QEvent>
#include <QFormLayout>

namespace tessera::ui {

NamePage::NamePage(Commissioning& work, QWidget* parent) : QWizardPage{parent}, work_{work} {
  setProperty("helpTopic", QStringLiteral("commissioning"));
  name_.setObjectName(QStringLiteral("vehicleName"));
  name_.setMaxLength(200);
  address_.setObjectName(QStringLiteral("vehicleAddress"));
  address_.setRange(1, 254);
  nameLabel_.setBuddy(&name_);
  addressLabel_.setBuddy(&address_);
  hint_.setWordWrap(true);
  hint_.setForegroundRole(QPalette::PlaceholderText);
  auto* form = new QFormLayout;
  form->addRow(&nameLabel_, &name_);
  form->addRow(&addressLabel_, &address_);
  form->addRow(nullptr, &hint_);
  form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
  auto* column = new QVBoxLayout{this};
  column->addLayout(form);
  column->addWidget(&notice_);
  column->addStretch();
  connect(&name_, &QLineEdit::textChanged, this, &NamePage::take);
  connect(&address_, &QSpinBox::valueChanged, this, &NamePage::take);
  retranslate();
}

void NamePage::initializePage() {
  showing_ = true;
  name_.setText(QString::fromStdString(work_.draft().name));
  address_.setValue(work_.draft().id.value);
  showing_ = false;
  name_.selectAll();
  remark();
}

void NamePage::take() {
  if (showing_) return;
  floor::VehicleSetup v = work_.draft();
  v.name = name_.text().trimmed().toStdString();
  v.id = VehicleId{static_cast<std::uint8_t>(address_.value())};
  work_.setDraft(v);
  remark();
}

void NamePage::remark() {
  const QString wrong = work_.complaint();
  if (!wrong.isEmpty()) {
    notice_.show(Notice::Tone::Error, wrong);
  } else if (work_.draft().id.value == 254) {
    notice_.show(Notice::Tone::Warning, tr("Vehicles that nobody has set up yet answer at 254. Another address avoids "
                                           "that two answer at once."));
  } else {
    notice_.clear();
  }
  Q_EMIT completeChanged();
}

bool NamePage::isComplete() const { return work_.complaint().isEmpty(); }

void NamePage::retranslate() {
  setTitle(tr("Name and address"));
  setSubTitle(tr("The name is for people; the address is the vehicle's number on the radio channel."));
  nameLabel_.setText(tr("&Name:"));
  addressLabel_.setText(tr("&Address (1 to 254):"));
  hint_.setText(tr("The lowest free address is proposed. No two vehicles of a channel may have the same one."));
}

void NamePage::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    retranslate();
    remark();
  }
  QWizardPage::changeEvent(event);
}

}  // namespace tessera::ui
