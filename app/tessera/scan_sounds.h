// What is heard while tags are registered: one high tone for a tag that is taken, two low ones for one that is not.
#pragma once

#include <QObject>
#include <QProcess>
#include <QTemporaryDir>
#include <memory>

#include "ui/register/registrar.h"

namespace tessera::desktop {

/// Through the system's player of sounds, as few desktops ring their bell any more (Wayland has none); where there is
/// no player, or it fails, by the bell.
class ScanSounds : public QObject {
  Q_OBJECT
public:
  explicit ScanSounds(QObject* parent = nullptr);
  ~ScanSounds() override;

  void play(ui::Registrar::Sound sound);

private:
  [[nodiscard]] QString fileOf(ui::Registrar::Sound sound);
  void ring(ui::Registrar::Sound sound);

  QStringList players_;                    ///< that have not failed yet
  std::unique_ptr<QTemporaryDir> folder_;  ///< made with the first sound: most starts of the program scan nothing
};

/// A sound file of tones of this pitch, one after the other.
[[nodiscard]] QByteArray tonesAsWav(double hertz, int tones);

}  // namespace tessera::desktop
