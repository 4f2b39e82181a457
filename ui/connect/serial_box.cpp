#include "ui/connect/serial_box.h"

#include <QEvent>
#include <QGridLayout>
#include <QLineEdit>
#include <QLocale>
#include <utility>

#include "floor/site_names.h"
#include "ui/base/icon.h"

namespace tessera::ui {

SerialBox::SerialBox(QWidget* parent) : QWidget{parent} {
  port_.setObjectName(QStringLiteral("portField"));
  port_.setEditable(true);
  port_.setInsertPolicy(QComboBox::NoInsert);
  port_.setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  port_.setMinimumContentsLength(28);
  port_.setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  refresh_.setObjectName(QStringLiteral("refreshPorts"));
  refresh_.setIcon(icon(QStringLiteral("refresh")));
  refresh_.setShortcut(QKeySequence::Refresh);
  baud_.setObjectName(QStringLiteral("baudField"));
  portLabel_.setBuddy(&port_);
  baudLabel_.setBuddy(&baud_);
  hint_.setWordWrap(true);
  hint_.setForegroundRole(QPalette::PlaceholderText);
  for (const int baud : floor::kBauds) baud_.addItem(QString{}, baud);

  auto* grid = new QGridLayout{this};
  grid->setContentsMargins(0, 0, 0, 0);
  grid->addWidget(&portLabel_, 0, 0);
  grid->addWidget(&port_, 0, 1);
  grid->addWidget(&refresh_, 0, 2);
  grid->addWidget(&hint_, 1, 1, 1, 2);
  grid->addWidget(&baudLabel_, 2, 0);
  grid->addWidget(&baud_, 2, 1, Qt::AlignLeft);
  grid->addWidget(&notice_, 3, 1, 1, 2);
  grid->setColumnStretch(1, 1);

  connect(&refresh_, &QToolButton::clicked, this, &SerialBox::refreshRequested);
  // Of an entry that is chosen the name alone goes to the field, not its description.
  connect(&port_, &QComboBox::activated, this, [this](int index) {
    if (const QString name = port_.itemData(index).toString(); !name.isEmpty()) port_.setEditText(name);
  });
  connect(&port_, &QComboBox::editTextChanged, this, &SerialBox::remark);
  connect(&baud_, &QComboBox::currentIndexChanged, this, &SerialBox::remark);
  setBaud(siteBaud_);
  retranslate();
}

void SerialBox::setPorts(std::vector<PortFound> ports) {
  ports_ = std::move(ports);
  fill();
}

void SerialBox::setPort(const QString& port) { port_.setEditText(port); }

void SerialBox::setBaud(int baud) {
  if (const int index = baud_.findData(baud); index >= 0) baud_.setCurrentIndex(index);
}

void SerialBox::setSiteBaud(int baud) {
  if (this->baud() == siteBaud_) setBaud(baud);
  siteBaud_ = baud;
  remark();
}

QString SerialBox::port() const { return port_.currentText().trimmed(); }

const PortFound* SerialBox::found() const {
  for (const PortFound& p : ports_)
    if (p.name == port()) return &p;
  return nullptr;
}

QString SerialBox::complaint() const {
  if (port().isEmpty()) return tr("Choose the port of the radio module, or type its path.");
  return {};
}

// What was typed or chosen stays; only an empty field takes the first free port.
void SerialBox::fill() {
  QString text = port();
  const QSignalBlocker quiet{&port_};
  port_.clear();
  for (const PortFound& p : ports_) {
    QString line = p.description.isEmpty() ? p.name : tr("%1 – %2", "port, description").arg(p.name, p.description);
    if (p.busy) line = tr("%1 (in use)").arg(line);
    port_.addItem(line, p.name);
    if (text.isEmpty() && !p.busy) text = p.name;
  }
  port_.setCurrentIndex(port_.findData(text));
  port_.setEditText(text);
  remark();
}

void SerialBox::remark() {
  const PortFound* p = found();
  if (ports_.empty() && port().isEmpty()) {
    notice_.show(Notice::Tone::Warning,
                 tr("No serial port was found. Plug the radio's USB adapter in and press Refresh. If it is plugged in "
                    "but not listed, it has no driver; on Linux, your user must also belong to the group “dialout” to "
                    "open it: “sudo adduser $USER dialout”, then log in anew."));
  } else if (p != nullptr && p->busy) {
    notice_.show(Notice::Tone::Warning, tr("Another program is using %1. Close it first.").arg(p->name));
  } else if (baud() != siteBaud_) {
    notice_.show(Notice::Tone::Info, tr("The site's radio is set to %1 baud. Choose another rate only if the module "
                                        "on this computer is set to it.")
                                         .arg(QLocale{}.toString(siteBaud_)));
  } else {
    notice_.clear();
  }
  Q_EMIT changed();
}

void SerialBox::retranslate() {
  portLabel_.setText(tr("&Port:"));
  port_.setAccessibleName(tr("Serial port"));
  port_.lineEdit()->setPlaceholderText(tr("e.g. /dev/ttyUSB0"));
  hint_.setText(tr("The radio module is usually /dev/ttyUSB0 (COM3 on Windows). Any path of a terminal will do."));
  refresh_.setText(tr("Refresh"));
  refresh_.setAccessibleName(tr("Look for ports again"));
  refresh_.setToolTip(
      tr("Look for ports again (%1)").arg(QKeySequence{QKeySequence::Refresh}.toString(QKeySequence::NativeText)));
  baudLabel_.setText(tr("&Baud rate:"));
  for (int i = 0; i < baud_.count(); ++i)
    baud_.setItemText(i, tr("%1 bit/s").arg(QLocale{}.toString(baud_.itemData(i).toInt())));
  fill();
}

void SerialBox::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

}  // namespace tessera::ui
