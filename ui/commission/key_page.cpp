#include "ui/commission/key_page.h"

#include <QApplication>
#include <QClipboard>
#include <QFontDatabase>
#include <QGridLayout>
#include <QHBoxLayout>

#include "ui/base/icon.h"
#include "ui/commission/vehicle_draft.h"

namespace tessera::ui {

KeyPage::KeyPage(Commissioning& work, QWidget* parent)
    : StepPage{work, Commissioning::Step::Key, Needs::Vehicle, parent} {
  pairKind_.setObjectName(QStringLiteral("pairKind"));
  knownKind_.setObjectName(QStringLiteral("knownKind"));
  pair_.setObjectName(QStringLiteral("pairVehicle"));
  typed_.setObjectName(QStringLiteral("typedKey"));
  use_.setObjectName(QStringLiteral("useKey"));
  key_.setObjectName(QStringLiteral("siteKey"));
  reveal_.setObjectName(QStringLiteral("revealKey"));
  copy_.setObjectName(QStringLiteral("copyKey"));
  result_.setObjectName(QStringLiteral("keyResult"));
  why_.setWordWrap(true);
  pairHint_.setWordWrap(true);
  pairHint_.setForegroundRole(QPalette::PlaceholderText);
  for (QLineEdit* field : {&typed_, &key_}) field->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  typed_.setMaxLength(80);
  key_.setReadOnly(true);
  key_.setEchoMode(QLineEdit::Password);
  reveal_.setCheckable(true);
  copy_.setIcon(icon(QStringLiteral("copy")));
  for (QPushButton* button : {&pair_, &use_, &reveal_, &copy_}) button->setAutoDefault(false);
  pairKind_.setChecked(true);

  auto* typedRow = new QHBoxLayout;
  typedRow->addWidget(&typed_, 1);
  typedRow->addWidget(&use_);
  auto* keyRow = new QHBoxLayout;
  keyRow->addWidget(&key_, 1);
  keyRow->addWidget(&reveal_);
  keyRow->addWidget(&copy_);
  auto* grid = new QGridLayout;
  grid->setColumnMinimumWidth(0, fontMetrics().height());
  grid->addWidget(&pairKind_, 0, 0, 1, 2);
  grid->addWidget(&pairHint_, 1, 1);
  grid->addWidget(&pair_, 2, 1, Qt::AlignLeft);
  grid->addWidget(&knownKind_, 3, 0, 1, 2);
  grid->addLayout(typedRow, 4, 1);
  grid->setRowMinimumHeight(5, fontMetrics().height());
  grid->addWidget(&keyLabel_, 6, 0, 1, 2);
  grid->addLayout(keyRow, 7, 1);
  grid->setColumnStretch(1, 1);
  content().addWidget(&why_);
  content().addLayout(grid);
  content().addWidget(&result_);
  content().addStretch();

  connect(&pairKind_, &QRadioButton::toggled, this, &KeyPage::showKind);
  connect(&use_, &QPushButton::clicked, this, &KeyPage::useTypedKey);
  connect(&typed_, &QLineEdit::textEdited, &result_, &Notice::clear);
  connect(&reveal_, &QPushButton::toggled, this,
          [this](bool on) { key_.setEchoMode(on ? QLineEdit::Normal : QLineEdit::Password); });
  connect(&copy_, &QPushButton::clicked, this,
          [this] { QApplication::clipboard()->setText(VehicleDraft::keyText(this->work().draft().key)); });
  showKind();
}

void KeyPage::initializePage() {
  if (!work().isNew()) knownKind_.setChecked(true);
  result_.clear();
  showKey();
  StepPage::initializePage();
}

void KeyPage::showKind() {
  pair_.setEnabled(pairKind_.isChecked());
  typed_.setEnabled(knownKind_.isChecked());
  use_.setEnabled(knownKind_.isChecked());
}

void KeyPage::showKey() { key_.setText(VehicleDraft::keyText(work().draft().key)); }

void KeyPage::useTypedKey() {
  const auto key = VehicleDraft::keyFromText(typed_.text());
  if (!key) {
    result_.show(Notice::Tone::Error, tr("A key has 32 hexadecimal digits (0–9, A–F); here are %n.", nullptr,
                                         static_cast<int>(typed_.text().remove(QLatin1Char(' ')).size())));
    typed_.setFocus();
    return;
  }
  floor::VehicleSetup v = work().draft();
  v.key = *key;
  work().setDraft(v);
  showKey();
  typed_.clear();
  if (const auto done = work().enter(); !done)
    result_.show(Notice::Tone::Error, QString::fromStdString(done.error().sentence));
  else
    result_.show(Notice::Tone::Info, tr("The site now uses this key. Waiting for the vehicle…"));
}

void KeyPage::refresh(const supervisor::VehicleView* vehicle) {
  if (vehicle == nullptr) return;
  result_.show(Notice::Tone::Good, tr("Vehicle and site share this key."));
  markDone();
}

void KeyPage::retranslate() {
  setTitle(tr("The vehicle's key"));
  setSubTitle(tr("Vehicle and site share a secret key; a vehicle obeys nobody without it."));
  why_.setText(tr("The key stands in the site's file: keep that as you would a password."));
  pairKind_.setText(tr("&Pair: give the vehicle a new random key over the air"));
  pairHint_.setText(tr("For a vehicle that nobody has set up yet."));
  pair_.setText(tr("Pair &now"));
  knownKind_.setText(tr("The vehicle has a &key that I know"));
  typed_.setPlaceholderText(tr("32 hexadecimal digits"));
  typed_.setAccessibleName(tr("The vehicle's key"));
  use_.setText(tr("&Use this key"));
  keyLabel_.setText(tr("Key of this vehicle in the site:"));
  keyLabel_.setBuddy(&key_);
  reveal_.setText(tr("Sho&w"));
  copy_.setText(tr("&Copy"));
  StepPage::retranslate();
}

}  // namespace tessera::ui
