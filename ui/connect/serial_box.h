// The part of the connection dialogue that names a serial port: chosen among those found, or typed.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QToolButton>
#include <QWidget>
#include <vector>

#include "ui/base/notice.h"
#include "ui/base/port_found.h"

namespace tessera::ui {

class SerialBox : public QWidget {
  Q_OBJECT
public:
  explicit SerialBox(QWidget* parent = nullptr);

  void setPorts(std::vector<PortFound> ports);
  void setPort(const QString& port);
  void setBaud(int baud);
  /// What the open site says; a different choice is remarked upon.
  void setSiteBaud(int baud);
  [[nodiscard]] QString port() const;
  [[nodiscard]] int baud() const { return baud_.currentData().toInt(); }
  /// One sentence that says why there can be no connection like this; empty: there can.
  [[nodiscard]] QString complaint() const;
  [[nodiscard]] QWidget* field() { return &port_; }

Q_SIGNALS:
  void refreshRequested();
  void changed();

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslate();
  void fill();
  void remark();
  [[nodiscard]] const PortFound* found() const;

  std::vector<PortFound> ports_;
  int siteBaud_ = 115200;
  QLabel portLabel_;
  QComboBox port_;
  QToolButton refresh_;
  QLabel hint_;
  QLabel baudLabel_;
  QComboBox baud_;
  Notice notice_;
};

}  // namespace tessera::ui
