#include "app/process/world_process.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <nlohmann/json.hpp>

namespace tessera::process {
namespace {

// An emulator takes 0.1 s to start and calibrating a compass a few seconds more; a busy machine takes longer.
constexpr int kStartMs = 120'000;
constexpr int kEndMs = 5'000;
constexpr int kMostSaid = 1000;  // characters of what it said that a sentence repeats

// Beside this program, or where a build tree keeps programs apart from tests.
QString worldProgram() {
  const QString here = QCoreApplication::applicationDirPath();
  const QString beside = here + QStringLiteral("/tessera-world");
  const QString apart = here + QStringLiteral("/../bin/tessera-world");
  return !QFileInfo::exists(beside) && QFileInfo::exists(apart) ? apart : beside;
}

}  // namespace

void WorldProcess::begin(const std::vector<std::string>& arguments) {
  QStringList words;
  for (const std::string& a : arguments) words << QString::fromStdString(a);
  const QString program = program_.isEmpty() ? worldProgram() : program_;
  process_.setProcessChannelMode(QProcess::SeparateChannels);
  // Whatever it prints must be taken, or it blocks on a full pipe.
  connect(&process_, &QProcess::readyReadStandardOutput, this, &WorldProcess::takeOutput);
  connect(&process_, &QProcess::readyReadStandardError, this, &WorldProcess::takeComplaints);
  connect(&process_, &QProcess::errorOccurred, this, [this, program](QProcess::ProcessError error) {
    if (error != QProcess::FailedToStart) return;
    fail(QStringLiteral("The simulated world %1 could not be started: %2.").arg(program, process_.errorString()));
  });
  connect(&process_, &QProcess::finished, this, [this] {
    if (!stopping_) fail(QStringLiteral("The simulated world has ended by itself. It said: %1").arg(complaint()));
  });
  process_.start(program, words);
}

Result<void> WorldProcess::start(const std::vector<std::string>& arguments) {
  begin(arguments);
  while (port_.empty() && failure_.isEmpty()) {
    if (process_.waitForReadyRead(kStartMs)) continue;
    fail(QStringLiteral("The simulated world did not start. It said: %1").arg(complaint()));
  }
  if (!failure_.isEmpty()) return failure(failure_.toStdString());
  return {};
}

WorldProcess::~WorldProcess() { stop(); }

void WorldProcess::command(const std::string& line) { process_.write((line + "\n").c_str()); }

void WorldProcess::stop() {
  if (stopping_ || process_.state() == QProcess::NotRunning) return;
  stopping_ = true;
  command("quit");
  process_.closeWriteChannel();
  if (process_.waitForFinished(kEndMs)) return;
  process_.terminate();
  if (process_.waitForFinished(kEndMs)) return;
  process_.kill();
  process_.waitForFinished(kEndMs);
}

void WorldProcess::takeOutput() {
  while (process_.canReadLine()) {
    const std::string line = process_.readLine().toStdString();
    if (!port_.empty()) {
      Q_EMIT answered(QString::fromStdString(line).trimmed());
      continue;
    }
    const auto answer = nlohmann::json::parse(line, nullptr, false);
    if (!answer.is_object() || !answer.contains("port") || !answer["port"].is_string()) {
      fail(QStringLiteral("The simulated world answered with something else than its port."));
      return;
    }
    port_ = answer["port"].get<std::string>();
    Q_EMIT ready(QString::fromStdString(port_));
  }
}

void WorldProcess::fail(const QString& sentence) {
  if (!failure_.isEmpty() || stopping_) return;
  failure_ = sentence;
  Q_EMIT died(sentence);
}

void WorldProcess::takeComplaints() {
  // A line comes in pieces where the pipe is full or the world is slow; its rest comes, or the world ends with it.
  process_.setReadChannel(QProcess::StandardError);
  QStringList lines;
  while (process_.canReadLine() || (process_.state() == QProcess::NotRunning && process_.bytesAvailable() > 0))
    lines << QString::fromUtf8(process_.readLine()).trimmed();
  process_.setReadChannel(QProcess::StandardOutput);
  for (const QString& line : lines) {
    if (line.isEmpty()) continue;
    said_ = (said_ + line + u' ').right(kMostSaid);
    Q_EMIT complained(line);
  }
}

QString WorldProcess::complaint() {
  takeComplaints();
  return said_.isEmpty() ? QStringLiteral("nothing") : said_.trimmed();
}

}  // namespace tessera::process
