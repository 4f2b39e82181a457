#include "app/cli/world_process.h"

#include <QCoreApplication>
#include <nlohmann/json.hpp>

namespace tessera::cli {
namespace {

// An emulator takes 0.1 s to start and calibrating a compass a few seconds more; a busy machine takes longer.
constexpr int kStartMs = 120'000;
constexpr int kEndMs = 5'000;

}  // namespace

Result<void> WorldProcess::start(const std::vector<std::string>& arguments) {
  QStringList words;
  for (const std::string& a : arguments) words << QString::fromStdString(a);
  const QString program = QCoreApplication::applicationDirPath() + QStringLiteral("/tessera-world");
  process_.setProcessChannelMode(QProcess::SeparateChannels);
  process_.start(program, words);
  if (!process_.waitForStarted()) {
    return failure("The simulated world " + program.toStdString() +
                   " could not be started: " + process_.errorString().toStdString() + ".");
  }
  while (!process_.canReadLine()) {
    if (!process_.waitForReadyRead(kStartMs)) {
      return failure("The simulated world did not start. It said: " + complaint().toStdString());
    }
  }
  const auto ready = nlohmann::json::parse(process_.readLine().toStdString(), nullptr, false);
  if (!ready.is_object() || !ready.contains("port") || !ready["port"].is_string()) {
    return failure("The simulated world answered with something else than its port.");
  }
  port_ = ready["port"].get<std::string>();
  connect(&process_, &QProcess::finished, this, [this] {
    if (!stopping_) Q_EMIT died(QStringLiteral("The simulated world has ended by itself. It said: ") + complaint());
  });
  // Whatever it prints must be taken, or it blocks on a full pipe.
  connect(&process_, &QProcess::readyReadStandardOutput, this, [this] { process_.readAllStandardOutput(); });
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

QString WorldProcess::complaint() {
  const QString said = QString::fromUtf8(process_.readAllStandardError()).trimmed();
  return said.isEmpty() ? QStringLiteral("nothing") : said;
}

}  // namespace tessera::cli
