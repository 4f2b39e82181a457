// The host's own E32 module on the workbench: its parameters read and written while it is in configuration mode. The
// program gives the window an implementation over the port.
#pragma once

#include <QObject>
#include <QString>

#include "link/e32_parameters.h"

namespace tessera::ui {

class RadioBench : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;

  /// Each answers once, by found() or failed(); one at a time. The supervision rests meanwhile.
  virtual void read() = 0;
  /// Writes, reads back and compares. found() brings what the module then holds.
  virtual void write(const link::E32Parameters& parameters) = 0;
  virtual void cancel() = 0;

Q_SIGNALS:
  void found(const tessera::link::E32Parameters& parameters);
  /// One complete sentence, with what to try next.
  void failed(const QString& sentence);
};

}  // namespace tessera::ui
