#include "ui/commission/step_page.h"

#include <QEvent>
#include <QHBoxLayout>

namespace tessera::ui {

StepPage::StepPage(Commissioning& work, Commissioning::Step step, Needs needs, QWidget* parent)
    : QWizardPage{parent}, work_{work}, step_{step}, needs_{needs}, content_{*new QVBoxLayout} {
  setProperty("helpTopic", QStringLiteral("commissioning"));
  silence_.setObjectName(QStringLiteral("silence"));
  connect_.setObjectName(QStringLiteral("connectFromWizard"));
  connect_.setAutoDefault(false);
  connect_.hide();
  skip_.setObjectName(QStringLiteral("skipStep"));
  auto* top = new QHBoxLayout;
  top->addWidget(&silence_, 1);
  top->addWidget(&connect_);
  auto* column = new QVBoxLayout{this};
  column->addLayout(top);
  column->addLayout(&content_, 1);
  column->addWidget(&skip_);

  connect(&connect_, &QPushButton::clicked, this, &StepPage::connectRequested);
  connect(&skip_, &QCheckBox::toggled, this, [this](bool skipped) {
    work_.setMark(step_, skipped ? Commissioning::Mark::Skipped : Commissioning::Mark::Open);
  });
  connect(&work_, &Commissioning::markChanged, this, [this] {
    const QSignalBlocker quiet{&skip_};
    skip_.setChecked(work_.mark(step_) == Commissioning::Mark::Skipped);
    skip_.setEnabled(work_.mark(step_) != Commissioning::Mark::Done);
    Q_EMIT completeChanged();
  });
  if (needs_ == Needs::Vehicle) connect(&work_, &Commissioning::seen, this, &StepPage::look);
}

bool StepPage::isComplete() const { return work_.mark(step_) != Commissioning::Mark::Open; }

void StepPage::initializePage() {
  retranslate();
  look();
}

void StepPage::markDone(bool done) {
  if (done)
    work_.setMark(step_, Commissioning::Mark::Done);
  else if (work_.mark(step_) == Commissioning::Mark::Done)
    work_.setMark(step_, Commissioning::Mark::Open);
}

void StepPage::look() {
  if (needs_ == Needs::Nothing) return;
  const QString why = work_.silence();
  if (why != silence_.text()) silence_.show(Notice::Tone::Warning, why);
  connect_.setVisible(!why.isEmpty() && !work_.supervised());
  if (isVisible()) refresh(why.isEmpty() ? work_.view() : nullptr);
}

void StepPage::showEvent(QShowEvent* event) {
  QWizardPage::showEvent(event);
  look();
}

void StepPage::retranslate() {
  connect_.setText(tr("Co&nnect…"));
  skip_.setText(tr("S&kip this step for now"));
  look();
}

void StepPage::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWizardPage::changeEvent(event);
}

}  // namespace tessera::ui
