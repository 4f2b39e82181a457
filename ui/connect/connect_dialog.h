// How shall the program reach the vehicles? A serial port, a serial device server, or the simulated world.
#pragma once

#include <QButtonGroup>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QRadioButton>
#include <vector>

#include "ui/base/connection_choice.h"
#include "ui/base/notice.h"
#include "ui/connect/serial_box.h"
#include "ui/connect/tcp_box.h"

namespace tessera::ui {

class ConnectDialog : public QDialog {
  Q_OBJECT
public:
  explicit ConnectDialog(QWidget* parent = nullptr);

  void setPorts(std::vector<PortFound> ports) { serial_.setPorts(std::move(ports)); }
  /// What the open site says of its radio; call before setChoice, which may say otherwise.
  void setSiteBaud(int baud) { serial_.setSiteBaud(baud); }
  /// What was chosen last.
  void setChoice(const ConnectionChoice& choice);
  /// Valid once the dialogue was accepted.
  [[nodiscard]] ConnectionChoice choice() const;
  void accept() override;

Q_SIGNALS:
  /// The answer is setPorts().
  void refreshRequested();

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslate();
  void showKind();
  [[nodiscard]] ConnectionChoice::Kind kind() const;

  QLabel intro_;
  QButtonGroup kinds_;
  QRadioButton demoKind_;
  QLabel demoHint_;
  QRadioButton serialKind_;
  SerialBox serial_;
  QRadioButton tcpKind_;
  TcpBox tcp_;
  Notice complaint_;
  QDialogButtonBox buttons_;
};

}  // namespace tessera::ui
