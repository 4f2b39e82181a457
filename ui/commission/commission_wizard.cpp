#include "ui/commission/commission_wizard.h"

#include <QEvent>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>

#include "ui/base/wording.h"
#include "ui/commission/compass_page.h"
#include "ui/commission/contact_page.h"
#include "ui/commission/drive_page.h"
#include "ui/commission/flash_page.h"
#include "ui/commission/jog_page.h"
#include "ui/commission/key_page.h"
#include "ui/commission/name_page.h"
#include "ui/commission/readers_page.h"
#include "ui/commission/settings_page.h"
#include "ui/commission/summary_page.h"
#include "ui/commission/type_page.h"

namespace tessera::ui {

CommissionWizard::CommissionWizard(FleetLink& link, SiteDocument& document, std::optional<VehicleId> editing,
                                   QWidget* parent)
    : QWizard{parent}, work_{link, document, editing} {
  setObjectName(QStringLiteral("commissionWizard"));
  setProperty("helpTopic", QStringLiteral("commissioning"));
  setWizardStyle(QWizard::ModernStyle);
  setOption(QWizard::NoDefaultButton, false);
  setOption(QWizard::HaveHelpButton, true);
  setOption(QWizard::HelpButtonOnRight, false);

  auto* key = new KeyPage{work_};
  auto* summary = new SummaryPage{work_};
  setPage(kType, new TypePage{work_});
  setPage(kName, new NamePage{work_});
  setPage(kFirmware, new FlashPage{work_});
  setPage(kKey, key);
  setPage(kContact, new ContactPage{work_});
  setPage(kSettings, new SettingsPage{work_});
  setPage(kReaders, new ReadersPage{work_});
  setPage(kCompass, new CompassPage{work_});
  setPage(kJog, new JogPage{work_});
  setPage(kDrive, new DrivePage{work_});
  setPage(kSummary, summary);
  for (const int id : pageIds())
    if (auto* step = qobject_cast<StepPage*>(page(id)))
      connect(step, &StepPage::connectRequested, this, &CommissionWizard::connectRequested);
  connect(key, &KeyPage::saveRequested, this, &CommissionWizard::saveRequested);
  connect(summary, &SummaryPage::calibrateRequested, this, [this] {
    accept();
    goesOnCalibrating_ = result() == QDialog::Accepted;
  });
  connect(&work_, &Commissioning::pairedChanged, this, &CommissionWizard::paired);
  connect(&work_, &Commissioning::siteChanged, this, &CommissionWizard::siteChanged);
  connect(&work_, &Commissioning::markChanged, this, &CommissionWizard::showSteps);
  connect(this, &QWizard::currentIdChanged, this, &CommissionWizard::showSteps);

  steps_.setTextFormat(Qt::RichText);
  steps_.setAlignment(Qt::AlignTop | Qt::AlignLeft);
  steps_.setMargin(fontMetrics().height() / 2);
  setSideWidget(&steps_);
  retranslate();
  const int line = fontMetrics().height();
  setMinimumSize(line * 66, line * 36);
}

// The vehicle goes into the site before the first page that speaks to it.
bool CommissionWizard::validateCurrentPage() {
  if (!QWizard::validateCurrentPage()) return false;
  if (currentId() != kFirmware) return true;
  if (const auto done = work_.enter(); !done) {
    QMessageBox::warning(this, windowTitle(), text(done.error().sentence));
    return false;
  }
  return true;
}

// Whichever page is shown: work goes on behind a page that was left.
bool CommissionWizard::mayClose() {
  for (const int id : pageIds()) {
    const auto* step = qobject_cast<StepPage*>(page(id));
    const QString why = step != nullptr ? step->holdsOpen() : QString{};
    if (why.isEmpty()) continue;
    QMessageBox::warning(this, windowTitle(), why);
    return false;
  }
  return true;
}

void CommissionWizard::accept() {
  if (mayClose()) QWizard::accept();
}

void CommissionWizard::reject() {
  if (!mayClose()) return;
  if (work_.paired() && work_.isNew()) {
    QMessageBox question{QMessageBox::Warning, windowTitle(),
                         tr("The vehicle has already taken its new key. Without this site it will obey nobody until it "
                            "is reset. Give it up all the same?"),
                         QMessageBox::NoButton, this};
    question.setObjectName(QStringLiteral("forgetKeyQuestion"));
    QPushButton* discard = question.addButton(tr("Give up"), QMessageBox::DestructiveRole);
    question.setDefaultButton(question.addButton(tr("Go on"), QMessageBox::RejectRole));
    question.exec();
    if (question.clickedButton() != discard) return;
  }
  work_.leave();
  QWizard::reject();
}

QString CommissionWizard::shortName(Page page) const {
  using Step = Commissioning::Step;
  switch (page) {
    case kType:
      return tr("Type");
    case kName:
      return tr("Name and address");
    case kFirmware:
      return SummaryPage::nameOf(Step::Firmware);
    case kKey:
      return SummaryPage::nameOf(Step::Key);
    case kContact:
      return SummaryPage::nameOf(Step::Contact);
    case kSettings:
      return SummaryPage::nameOf(Step::Settings);
    case kReaders:
      return SummaryPage::nameOf(Step::Readers);
    case kCompass:
      return SummaryPage::nameOf(Step::Compass);
    case kJog:
      return SummaryPage::nameOf(Step::Jog);
    case kDrive:
      return SummaryPage::nameOf(Step::Drive);
    default:
      return tr("Summary");
  }
}

void CommissionWizard::showSteps() {
  QString rows;
  for (int id = 0; id < kPages; ++id) {
    QString mark;
    if (id >= kFirmware && id <= kDrive) {
      const auto m = work_.mark(static_cast<Commissioning::Step>(id - kFirmware));
      if (m == Commissioning::Mark::Done) mark = QStringLiteral("✓");
      if (m == Commissioning::Mark::Skipped) mark = QStringLiteral("–");
    } else if (id < currentId()) {
      mark = QStringLiteral("✓");
    }
    const QString name = shortName(static_cast<Page>(id)).toHtmlEscaped();
    rows += QStringLiteral("<tr><td width='%1'>%2</td><td style='white-space:nowrap'>%3</td></tr>")
                .arg(fontMetrics().averageCharWidth() * 3)
                .arg(mark, id == currentId() ? QStringLiteral("<b>%1</b>").arg(name) : name);
  }
  // As wide as its widest line in bold, so that nothing moves from page to page.
  QFont bold = font();
  bold.setBold(true);
  int widest = 0;
  for (int id = 0; id < kPages; ++id)
    widest = std::max(widest, QFontMetrics{bold}.horizontalAdvance(shortName(static_cast<Page>(id))));
  steps_.setMinimumWidth(widest + fontMetrics().averageCharWidth() * 6 + 2 * steps_.margin());
  steps_.setText(QStringLiteral("<table cellpadding='2'>%1</table>").arg(rows));
}

void CommissionWizard::retranslate() {
  setWindowTitle(work_.isNew() ? tr("Set up a vehicle")
                               : tr("Set up %1 again").arg(QString::fromStdString(work_.draft().name)));
  setButtonText(QWizard::BackButton, tr("< &Back"));
  setButtonText(QWizard::NextButton, tr("&Next >"));
  setButtonText(QWizard::FinishButton, tr("&Finish"));
  setButtonText(QWizard::CancelButton, tr("Cancel"));
  setButtonText(QWizard::HelpButton, tr("&Help"));
  steps_.setAccessibleName(tr("Steps"));
  showSteps();
}

void CommissionWizard::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWizard::changeEvent(event);
}

}  // namespace tessera::ui
