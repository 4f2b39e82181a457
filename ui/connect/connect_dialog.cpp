#include "ui/connect/connect_dialog.h"

#include <QEvent>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>

#include "ui/connect/fit_height.h"

namespace tessera::ui {
namespace {

// Under its radio button, as deep as the button's text.
QLayout* indentedUnderButton(QWidget& button, QWidget& content) {
  const QStyle& style = *button.style();
  auto* row = new QHBoxLayout;
  row->setContentsMargins(
      style.pixelMetric(QStyle::PM_ExclusiveIndicatorWidth) + style.pixelMetric(QStyle::PM_RadioButtonLabelSpacing), 0,
      0, button.fontMetrics().height() / 2);
  row->addWidget(&content);
  return row;
}

}  // namespace

ConnectDialog::ConnectDialog(QWidget* parent) : QDialog{parent} {
  setObjectName(QStringLiteral("connectDialog"));
  setProperty("helpTopic", QStringLiteral("connecting"));
  demoKind_.setObjectName(QStringLiteral("demoKind"));
  serialKind_.setObjectName(QStringLiteral("serialKind"));
  tcpKind_.setObjectName(QStringLiteral("tcpKind"));
  complaint_.setObjectName(QStringLiteral("complaint"));
  intro_.setWordWrap(true);
  demoHint_.setWordWrap(true);
  demoHint_.setForegroundRole(QPalette::PlaceholderText);
  kinds_.addButton(&demoKind_, static_cast<int>(ConnectionChoice::Kind::Demo));
  kinds_.addButton(&serialKind_, static_cast<int>(ConnectionChoice::Kind::Serial));
  kinds_.addButton(&tcpKind_, static_cast<int>(ConnectionChoice::Kind::Tcp));
  buttons_.setStandardButtons(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  buttons_.button(QDialogButtonBox::Ok)->setObjectName(QStringLiteral("connectButton"));

  auto* column = new QVBoxLayout{this};
  column->addWidget(&intro_);
  column->addSpacing(fontMetrics().height() / 2);
  column->addWidget(&serialKind_);
  column->addLayout(indentedUnderButton(serialKind_, serial_));
  column->addWidget(&tcpKind_);
  column->addLayout(indentedUnderButton(tcpKind_, tcp_));
  column->addWidget(&demoKind_);
  column->addLayout(indentedUnderButton(demoKind_, demoHint_));
  column->addStretch();
  column->addWidget(&complaint_);
  column->addWidget(&buttons_);

  connect(&kinds_, &QButtonGroup::idToggled, this, [this](int, bool on) {
    if (on) showKind();
  });
  connect(&serial_, &SerialBox::refreshRequested, this, &ConnectDialog::refreshRequested);
  connect(&serial_, &SerialBox::changed, &complaint_, &Notice::clear);
  connect(&tcp_, &TcpBox::changed, &complaint_, &Notice::clear);
  connect(&buttons_, &QDialogButtonBox::accepted, this, &ConnectDialog::accept);
  connect(&buttons_, &QDialogButtonBox::rejected, this, &ConnectDialog::reject);
  serialKind_.setChecked(true);
  retranslate();
  new FitHeight{*this, fontMetrics().height() * 34};
}

void ConnectDialog::setChoice(const ConnectionChoice& choice) {
  kinds_.button(static_cast<int>(choice.kind))->setChecked(true);
  if (!choice.port.isEmpty()) serial_.setPort(choice.port);
  if (choice.kind == ConnectionChoice::Kind::Serial) serial_.setBaud(choice.baud);
  tcp_.setHost(choice.host);
  if (choice.tcpPort != 0) tcp_.setPort(choice.tcpPort);
}

ConnectionChoice ConnectDialog::choice() const {
  return {kind(), serial_.port(), serial_.baud(), tcp_.host(), tcp_.port()};
}

ConnectionChoice::Kind ConnectDialog::kind() const { return static_cast<ConnectionChoice::Kind>(kinds_.checkedId()); }

void ConnectDialog::showKind() {
  serial_.setEnabled(kind() == ConnectionChoice::Kind::Serial);
  tcp_.setEnabled(kind() == ConnectionChoice::Kind::Tcp);
  complaint_.clear();
}

void ConnectDialog::accept() {
  const bool serial = kind() == ConnectionChoice::Kind::Serial;
  const bool tcp = kind() == ConnectionChoice::Kind::Tcp;
  const QString wrong = serial ? serial_.complaint() : tcp ? tcp_.complaint() : QString{};
  if (wrong.isEmpty()) {
    QDialog::accept();
    return;
  }
  complaint_.show(Notice::Tone::Error, wrong);
  (serial ? serial_.field() : tcp_.field())->setFocus();
}

void ConnectDialog::retranslate() {
  setWindowTitle(tr("Connect to the vehicles"));
  intro_.setText(tr("The vehicles are reached by radio, through a module at one of this computer's ports."));
  demoKind_.setText(tr("&Demo world"));
  demoHint_.setText(tr("The site's vehicles, floor and radio are simulated on this computer. No hardware is needed."));
  serialKind_.setText(tr("&Serial port"));
  tcpKind_.setText(tr("&Network (TCP)"));
  buttons_.button(QDialogButtonBox::Ok)->setText(tr("&Connect"));
  buttons_.button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
}

void ConnectDialog::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QDialog::changeEvent(event);
}

}  // namespace tessera::ui
