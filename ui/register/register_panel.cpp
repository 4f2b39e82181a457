#include "ui/register/register_panel.h"

#include <QEvent>
#include <QScrollArea>

namespace tessera::ui {

RegisterPanel::RegisterPanel(Registrar& registrar, QWidget* parent)
    : QStackedWidget{parent}, registrar_{registrar}, setup_{new SetupPage{registrar}}, page_{new ScanPage{registrar}} {
  setObjectName(QStringLiteral("registerPanel"));
  setWindowTitle(tr("Register tags"));
  // It scrolls where there is no room: a panel must not make the window larger.
  auto* scroll = new QScrollArea;
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(setup_);
  addWidget(scroll);
  addWidget(page_);
  connect(setup_, &SetupPage::startRequested, &registrar_, &Registrar::start);
  connect(page_, &ScanPage::showRequested, this, &RegisterPanel::showRequested);
  connect(&registrar_, &Registrar::changed, this, &RegisterPanel::showState);
}

void RegisterPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) setWindowTitle(tr("Register tags"));
  QStackedWidget::changeEvent(event);
}

void RegisterPanel::showState() {
  const int wanted = registrar_.state() == Registrar::State::Idle ? 0 : 1;
  if (wanted == currentIndex()) return;
  setCurrentIndex(wanted);
  if (wanted == 0) {
    setup_->setSounds(registrar_.reader().sounds);
    setup_->refresh();
  } else {
    page_->setFocus();
  }
}

}  // namespace tessera::ui
