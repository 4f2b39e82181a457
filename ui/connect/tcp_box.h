// The part of the connection dialogue that names a serial device server: a radio module reached over the network.
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QWidget>

namespace tessera::ui {

class TcpBox : public QWidget {
  Q_OBJECT
public:
  explicit TcpBox(QWidget* parent = nullptr);

  void setHost(const QString& host) { host_.setText(host); }
  void setPort(quint16 port) { port_.setValue(port); }
  [[nodiscard]] QString host() const { return host_.text().trimmed(); }
  [[nodiscard]] quint16 port() const { return static_cast<quint16>(port_.value()); }
  /// One sentence that says why there can be no connection like this; empty: there can.
  [[nodiscard]] QString complaint() const;
  [[nodiscard]] QWidget* field() { return &host_; }

Q_SIGNALS:
  void changed();

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslate();

  QLabel hostLabel_;
  QLineEdit host_;
  QLabel portLabel_;
  QSpinBox port_;
  QLabel hint_;
};

}  // namespace tessera::ui
