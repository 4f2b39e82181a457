#include "app/tessera/scan_sounds.h"

#include <QApplication>
#include <QDataStream>
#include <QFile>
#include <QStandardPaths>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace tessera::desktop {
namespace {

using Sound = ui::Registrar::Sound;

constexpr int kSamplesPerSecond = 44'100;
constexpr int kToneSamples = kSamplesPerSecond / 9;
constexpr int kGapSamples = kSamplesPerSecond / 20;
constexpr double kFadeSamples = 300.0;  // without it a tone begins and ends with a crack
constexpr double kLoudness = 14'000.0;  // of 32,767
constexpr int kBetweenBellsMs = 180;

QStringList playersOfSounds() {
  QStringList players;
  for (const char* name : {"pw-play", "paplay", "aplay"}) {
    const QString path = QStandardPaths::findExecutable(QString::fromLatin1(name));
    if (!path.isEmpty()) players << path;
  }
  return players;
}

}  // namespace

QByteArray tonesAsWav(double hertz, int tones) {
  const int samples = tones * kToneSamples + (tones - 1) * kGapSamples;
  QByteArray bytes;
  QDataStream out{&bytes, QIODevice::WriteOnly};
  out.setByteOrder(QDataStream::LittleEndian);
  out.writeRawData("RIFF", 4);
  out << static_cast<qint32>(36 + 2 * samples);
  out.writeRawData("WAVEfmt ", 8);
  // One channel of 16 bits.
  out << qint32{16} << qint16{1} << qint16{1} << qint32{kSamplesPerSecond} << qint32{2 * kSamplesPerSecond} << qint16{2}
      << qint16{16};
  out.writeRawData("data", 4);
  out << static_cast<qint32>(2 * samples);
  for (int n = 0; n < samples; ++n) {
    const int within = n % (kToneSamples + kGapSamples);
    const double fade = std::min({1.0, within / kFadeSamples, (kToneSamples - within) / kFadeSamples});
    const double wave = std::sin(2.0 * std::numbers::pi * hertz * within / kSamplesPerSecond);
    out << static_cast<qint16>(within < kToneSamples ? std::lround(kLoudness * fade * wave) : 0);
  }
  return bytes;
}

ScanSounds::ScanSounds(QObject* parent) : QObject{parent}, players_{playersOfSounds()} {}

ScanSounds::~ScanSounds() {
  for (QProcess* playing : findChildren<QProcess*>()) {
    playing->disconnect(this);
    playing->kill();
    playing->waitForFinished();
  }
}

QString ScanSounds::fileOf(Sound sound) {
  const bool good = sound == Sound::Registered;
  if (!folder_) folder_ = std::make_unique<QTemporaryDir>();
  const QString path = folder_->filePath(good ? QStringLiteral("registered.wav") : QStringLiteral("refused.wav"));
  if (QFile::exists(path)) return path;
  QFile file{path};
  if (file.open(QIODevice::WriteOnly)) file.write(good ? tonesAsWav(1568.0, 1) : tonesAsWav(392.0, 2));
  return path;
}

void ScanSounds::play(Sound sound) {
  if (players_.isEmpty()) return ring(sound);
  auto* playing = new QProcess{this};
  const auto failed = [this, sound, player = players_.front()] {
    players_.removeOne(player);
    play(sound);
  };
  connect(playing, &QProcess::errorOccurred, this, [playing, failed](QProcess::ProcessError error) {
    if (error != QProcess::FailedToStart) return;
    playing->deleteLater();
    failed();
  });
  connect(playing, &QProcess::finished, this, [playing, failed](int code) {
    playing->deleteLater();
    if (code != 0) failed();
  });
  playing->setStandardOutputFile(QProcess::nullDevice());
  playing->setStandardErrorFile(QProcess::nullDevice());
  playing->start(players_.front(), {fileOf(sound)});
}

void ScanSounds::ring(Sound sound) {
  QApplication::beep();
  if (sound == Sound::Refused) QTimer::singleShot(kBetweenBellsMs, this, [] { QApplication::beep(); });
}

}  // namespace tessera::desktop
