#include "ui/commission/key_page.h"

#include <QApplication>
#include <QClipboard>
#include <QFontDatabase>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHideEvent>

#include "ui/base/icon.h"
#include "ui/base/wording.h"
#include "ui/commission/vehicle_draft.h"
#include "wire/pairing.h"

namespace tessera::ui {

KeyPage::KeyPage(Commissioning& work, QWidget* parent)
    : StepPage{work, Commissioning::Step::Key, Needs::Vehicle, parent}, pairing_{work} {
  pairKind_.setObjectName(QStringLiteral("pairKind"));
  knownKind_.setObjectName(QStringLiteral("knownKind"));
  pair_.setObjectName(QStringLiteral("pairVehicle"));
  typed_.setObjectName(QStringLiteral("typedKey"));
  use_.setObjectName(QStringLiteral("useKey"));
  key_.setObjectName(QStringLiteral("siteKey"));
  reveal_.setObjectName(QStringLiteral("revealKey"));
  copy_.setObjectName(QStringLiteral("copyKey"));
  result_.setObjectName(QStringLiteral("keyResult"));
  unsaved_.setObjectName(QStringLiteral("keyUnsaved"));
  save_.setObjectName(QStringLiteral("saveKey"));
  save_.setIcon(icon(QStringLiteral("save")));
  why_.setWordWrap(true);
  pairHint_.setWordWrap(true);
  pairHint_.setForegroundRole(QPalette::PlaceholderText);
  for (QLineEdit* field : {&typed_, &key_}) field->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  typed_.setMaxLength(80);
  key_.setReadOnly(true);
  key_.setEchoMode(QLineEdit::Password);
  reveal_.setCheckable(true);
  copy_.setIcon(icon(QStringLiteral("copy")));
  for (QPushButton* button : {&pair_, &use_, &reveal_, &copy_, &save_}) button->setAutoDefault(false);
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
  content().addWidget(&unsaved_);
  content().addWidget(&save_, 0, Qt::AlignLeft);
  content().addStretch();

  connect(&pairKind_, &QRadioButton::toggled, this, &KeyPage::showKind);
  connect(&pair_, &QPushButton::clicked, this, &KeyPage::pair);
  connect(&pairing_, &Pairing::progressed, this,
          [this](const QString& sentence) { result_.show(Notice::Tone::Info, sentence); });
  connect(&pairing_, &Pairing::failed, this, [this](const QString& sentence) {
    result_.show(Notice::Tone::Error, sentence);
    showKind();
  });
  connect(&pairing_, &Pairing::done, this, [this] {
    result_.show(Notice::Tone::Good, tr("The vehicle has its key; nobody else knows it. Waiting for contact…"));
    showKey();
    showKind();
  });
  connect(&use_, &QPushButton::clicked, this, &KeyPage::useTypedKey);
  connect(&typed_, &QLineEdit::textEdited, &result_, &Notice::clear);
  connect(&reveal_, &QPushButton::toggled, this,
          [this](bool on) { key_.setEchoMode(on ? QLineEdit::Normal : QLineEdit::Password); });
  connect(&copy_, &QPushButton::clicked, this,
          [this] { QApplication::clipboard()->setText(VehicleDraft::keyText(this->work().draft().key)); });
  connect(&save_, &QPushButton::clicked, this, &KeyPage::saveRequested);
  connect(&this->work(), &Commissioning::pairedChanged, this, &KeyPage::showWhetherSaved);
  connect(&this->work().document(), &SiteDocument::modifiedChanged, this, &KeyPage::showWhetherSaved);
  showKind();
}

void KeyPage::initializePage() {
  if (!work().isNew()) knownKind_.setChecked(true);
  result_.clear();
  showKey();
  StepPage::initializePage();
}

void KeyPage::pair() {
  if (pairing_.isRunning()) {
    const QString doubt = pairing_.doubt();
    pairing_.cancel();
    result_.show(doubt.isEmpty() ? Notice::Tone::Info : Notice::Tone::Warning,
                 doubt.isEmpty() ? tr("Pairing was given up.") : doubt);
  } else {
    pairing_.start();
  }
  showKind();
}

void KeyPage::hideEvent(QHideEvent* event) {
  // The window may be minimised meanwhile; another page means that pairing was given up.
  if (!event->spontaneous() && pairing_.isRunning()) pair();
  StepPage::hideEvent(event);
}

void KeyPage::showKind() {
  const bool busy = pairing_.isRunning();
  pair_.setText(busy ? tr("Give up pairi&ng") : tr("Pair &now"));
  pairKind_.setEnabled(!busy);
  knownKind_.setEnabled(!busy);
  pair_.setEnabled(pairKind_.isChecked() && (busy || work().supervised()));
  typed_.setEnabled(knownKind_.isChecked());
  use_.setEnabled(knownKind_.isChecked());
}

void KeyPage::showKey() { key_.setText(VehicleDraft::keyText(work().draft().key)); }

// The vehicle obeys this key alone from now on.
void KeyPage::showWhetherSaved() {
  const bool unsaved = work().paired() && work().document().isModified();
  save_.setVisible(unsaved);
  if (unsaved)
    unsaved_.show(Notice::Tone::Warning, tr("The site's file does not have this key yet. Without it the vehicle obeys "
                                            "nobody: save the site now."));
  else
    unsaved_.clear();
}

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
    result_.show(Notice::Tone::Error, text(done.error().sentence));
  else
    result_.show(Notice::Tone::Info, tr("The site now uses this key. Waiting for the vehicle…"));
}

void KeyPage::refresh(const supervisor::VehicleView* vehicle) {
  showKind();
  if (vehicle == nullptr || pairing_.isRunning() || vehicle->id != work().draft().id) return;
  if (work().draft().key == wire::kFactoryKey) {
    result_.show(Notice::Tone::Warning,
                 tr("The vehicle still has the factory's key, which everybody knows. Pair it now."));
    return;
  }
  result_.show(Notice::Tone::Good, tr("Vehicle and site share this key."));
  markDone();
}

void KeyPage::retranslate() {
  setTitle(tr("The vehicle's key"));
  setSubTitle(tr("Vehicle and site share a secret key; a vehicle obeys nobody without it."));
  why_.setText(tr("The key stands in the site's file: keep that as you would a password."));
  pairKind_.setText(tr("&Pair: give the vehicle a new random key over the air"));
  pairHint_.setText(
      tr("A vehicle fresh from the factory (address 254, a key that everybody knows) also takes its address. Switch on "
         "only this one. Who listens to the radio during pairing could learn the key: pair where you are alone."));
  showKind();
  knownKind_.setText(tr("The vehicle has a &key that I know"));
  typed_.setPlaceholderText(tr("32 hexadecimal digits"));
  typed_.setAccessibleName(tr("The vehicle's key"));
  use_.setText(tr("&Use this key"));
  keyLabel_.setText(tr("Key of this vehicle in the site:"));
  keyLabel_.setBuddy(&key_);
  reveal_.setText(tr("Sho&w"));
  copy_.setText(tr("&Copy"));
  save_.setText(tr("Sa&ve the site"));
  showWhetherSaved();
  StepPage::retranslate();
}

}  // namespace tessera::ui
