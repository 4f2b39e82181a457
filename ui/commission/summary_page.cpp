#include "ui/commission/summary_page.h"

#include <QEvent>
#include <QVBoxLayout>

namespace tessera::ui {

SummaryPage::SummaryPage(Commissioning& work, QWidget* parent) : QWizardPage{parent}, work_{work} {
  setProperty("helpTopic", QStringLiteral("commissioning"));
  list_.setObjectName(QStringLiteral("summary"));
  list_.setTextFormat(Qt::RichText);
  list_.setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* column = new QVBoxLayout{this};
  column->addWidget(&list_);
  column->addWidget(&notice_);
  next_.setWordWrap(true);
  column->addWidget(&next_);
  calibrate_.setObjectName(QStringLiteral("calibrateNext"));
  calibrate_.setAutoDefault(false);
  column->addWidget(&calibrate_, 0, Qt::AlignLeft);
  connect(&calibrate_, &QPushButton::clicked, this, &SummaryPage::calibrateRequested);
  column->addStretch();
  retranslate();
}

QString SummaryPage::nameOf(Commissioning::Step step) {
  using Step = Commissioning::Step;
  switch (step) {
    case Step::Firmware:
      return tr("Firmware");
    case Step::Key:
      return tr("Key");
    case Step::Contact:
      return tr("Contact");
    case Step::Settings:
      return tr("Settings");
    case Step::Readers:
      return tr("Readers");
    case Step::Compass:
      return tr("Compass");
    case Step::Jog:
      return tr("Drive by hand");
    case Step::Drive:
      break;
  }
  return tr("First drive");
}

QString SummaryPage::nameOf(Commissioning::Mark mark) {
  switch (mark) {
    case Commissioning::Mark::Done:
      return tr("done");
    case Commissioning::Mark::Skipped:
      return tr("skipped");
    case Commissioning::Mark::Open:
      break;
  }
  return tr("not done");
}

void SummaryPage::retranslate() {
  const QString name = QString::fromStdString(work_.draft().name);
  setTitle(tr("Summary"));
  setSubTitle(tr("%1 stands in the site under the address %2.").arg(name).arg(work_.address().value));
  QString rows;
  int left = 0;
  for (std::size_t i = 0; i < Commissioning::kSteps; ++i) {
    const auto step = static_cast<Commissioning::Step>(i);
    const Commissioning::Mark mark = work_.mark(step);
    left += mark == Commissioning::Mark::Done ? 0 : 1;
    const QString word =
        mark == Commissioning::Mark::Done ? nameOf(mark) : QStringLiteral("<b>%1</b>").arg(nameOf(mark));
    rows += QStringLiteral("<tr><td style='padding-right:2em'>%1</td><td>%2</td></tr>").arg(nameOf(step), word);
  }
  list_.setText(QStringLiteral("<table cellpadding='3'>%1</table>").arg(rows));
  const QString kept = work_.document().isModified() ? tr("Save the site to keep the vehicle.")
                                                     : tr("The vehicle is saved with the site.");
  const QString tried =
      left == 0
          ? tr("Everything was tried.")
          : tr("%n step(s) were left out. Open this wizard for the vehicle again to make up for it.", nullptr, left);
  next_.setText(
      tr("Where exactly the readers sit and how large the wheels are, a drive along a figure over registered "
         "tags tells better than a ruler."));
  calibrate_.setText(tr("Finish, and calibrate readers and &wheels…"));
  notice_.show(left == 0 ? Notice::Tone::Good : Notice::Tone::Warning, tried + QLatin1Char(' ') + kept);
}

void SummaryPage::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWizardPage::changeEvent(event);
}

}  // namespace tessera::ui
