// How the firmware gets onto the vehicle's board, with commands to copy; and how to try all this without a vehicle.
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <array>

#include "ui/commission/step_page.h"

namespace tessera::ui {

/// The firmware's plain image that came with a program which lies in this folder; empty where none did.
[[nodiscard]] QString firmwareImage(const QString& programFolder);

class FlashPage : public StepPage {
  Q_OBJECT
public:
  explicit FlashPage(Commissioning& work, QWidget* parent = nullptr);
  /// The commands write this image, such as came with the program; empty: what is built from the sources.
  void useImage(const QString& file);

protected:
  void retranslate() override;

private:
  struct Command {
    QLabel what;
    QLineEdit line;
    QPushButton copy;
  };
  QString image_;
  QLabel intro_;
  std::array<Command, 3> commands_;
  QLabel demo_;
  QPushButton done_;
};

}  // namespace tessera::ui
