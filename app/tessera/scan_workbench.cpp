#include "app/tessera/scan_workbench.h"

#include "host/port_choice.h"
#include "host/serial_ports.h"
#include "ui/base/wording.h"

namespace tessera::desktop {

std::vector<ui::PortFound> portsFound() {
  std::vector<ui::PortFound> ports;
  for (const host::SerialPortFound& found : host::serialPorts())
    ports.push_back(
        {found.port, found.builtIn ? ScanWorkbench::tr("built into this computer") : found.description, false});
  return ports;
}

ScanWorkbench::~ScanWorkbench() { close(); }

std::vector<ui::PortFound> ScanWorkbench::ports() { return portsFound(); }

void ScanWorkbench::open(const QString& port, int baud) {
  close();
  const auto tellLost = [this](const QString& name, const Sentence& reason) {
    const auto sentence =
        phrase("Core", "The reader's port %1 cannot be used: %2. It is taken up as soon as it is there.")
            .with(name.toStdString(), reason);
    Q_EMIT lost(ui::text(sentence));
  };
  const auto choice = host::PortChoice::parse(port, baud);
  if (!choice) {
    Q_EMIT lost(ui::text(choice.error().sentence));
    return;
  }
  port_ = host::makePort(*choice);
  // Queued: whoever hears of it may close the port, which must not go within its own signal.
  const auto queued = Qt::QueuedConnection;
  connect(
      port_.get(), &host::BytePort::opened, this, [this] { Q_EMIT opened(); }, queued);
  connect(
      port_.get(), &host::BytePort::lost, this, [port, tellLost](const Sentence& reason) { tellLost(port, reason); },
      queued);
  connect(
      port_.get(), &host::BytePort::received, this, [this](const QByteArray& bytes) { Q_EMIT received(bytes); },
      queued);
  port_->open();
}

void ScanWorkbench::close() {
  if (!port_) return;
  port_->disconnect(this);
  port_->close();
  port_.release()->deleteLater();
}

void ScanWorkbench::send(const QByteArray& bytes) {
  if (port_)
    port_->write({reinterpret_cast<const std::uint8_t*>(bytes.constData()), static_cast<std::size_t>(bytes.size())});
}

}  // namespace tessera::desktop
