// The port of a tag reader that a person holds. The program gives the window an implementation over its serial ports.
#pragma once

#include <QByteArray>
#include <QObject>
#include <QString>
#include <vector>

#include "ui/base/port_found.h"

namespace tessera::ui {

class ScanBench : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;

  [[nodiscard]] virtual std::vector<PortFound> ports() = 0;
  /// opened() or lost() follow; a port that was lost is opened again as soon as it is there.
  virtual void open(const QString& port, int baud) = 0;
  virtual void close() = 0;
  virtual void send(const QByteArray& bytes) = 0;

Q_SIGNALS:
  void opened();
  /// One complete sentence, once until it is opened again.
  void lost(const QString& sentence);
  void received(const QByteArray& bytes);
};

}  // namespace tessera::ui
