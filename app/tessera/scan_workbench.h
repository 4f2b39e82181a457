// The serial port of a person's tag reader, for as long as tags are registered.
#pragma once

#include <memory>

#include "host/byte_port.h"
#include "ui/register/scan_bench.h"

namespace tessera::desktop {

class ScanWorkbench final : public ui::ScanBench {
  Q_OBJECT
public:
  using ScanBench::ScanBench;
  ~ScanWorkbench() override;

  [[nodiscard]] std::vector<ui::PortFound> ports() override;
  void open(const QString& port, int baud) override;
  void close() override;
  void send(const QByteArray& bytes) override;

private:
  std::unique_ptr<host::BytePort> port_;
};

/// The serial ports of this computer that a device may be at.
[[nodiscard]] std::vector<ui::PortFound> portsFound();

}  // namespace tessera::desktop
