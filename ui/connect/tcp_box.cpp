#include "ui/connect/tcp_box.h"

#include <QEvent>
#include <QGridLayout>
#include <algorithm>

namespace tessera::ui {

TcpBox::TcpBox(QWidget* parent) : QWidget{parent} {
  host_.setObjectName(QStringLiteral("hostField"));
  port_.setObjectName(QStringLiteral("tcpPortField"));
  port_.setRange(1, 65535);
  port_.setGroupSeparatorShown(false);
  port_.setValue(4001);
  hostLabel_.setBuddy(&host_);
  portLabel_.setBuddy(&port_);
  hint_.setWordWrap(true);
  hint_.setForegroundRole(QPalette::PlaceholderText);

  auto* grid = new QGridLayout{this};
  grid->setContentsMargins(0, 0, 0, 0);
  grid->addWidget(&hostLabel_, 0, 0);
  grid->addWidget(&host_, 0, 1);
  grid->addWidget(&portLabel_, 0, 2);
  grid->addWidget(&port_, 0, 3);
  grid->addWidget(&hint_, 1, 1, 1, 3);
  grid->setColumnStretch(1, 1);
  connect(&host_, &QLineEdit::textChanged, this, &TcpBox::changed);
  connect(&port_, &QSpinBox::valueChanged, this, &TcpBox::changed);
  retranslate();
}

QString TcpBox::complaint() const {
  const QString name = host();
  if (name.isEmpty()) return tr("Type the name or address of the serial device server.");
  const bool strange = std::any_of(name.begin(), name.end(), [](QChar c) {
    return c.isSpace() || c == QLatin1Char('/') || c == QLatin1Char('@') || c == QLatin1Char('?');
  });
  if (strange)
    return tr("“%1” is no name or address of a computer. Type it alone, such as 192.168.0.7, and the port beside it.")
        .arg(name);
  return {};
}

void TcpBox::retranslate() {
  hostLabel_.setText(tr("&Host:"));
  host_.setPlaceholderText(tr("e.g. 192.168.0.7"));
  portLabel_.setText(tr("P&ort number:"));
  hint_.setText(
      tr("For a radio module behind a serial device server that passes raw bytes over TCP. Its baud rate is set there. "
         "Such a server encrypts nothing: keep it in a network of its own."));
}

void TcpBox::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

}  // namespace tessera::ui
