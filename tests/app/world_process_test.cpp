// What a world says to its error stream, however it comes through the pipe.
#include "app/process/world_process.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QFile>
#include <QTemporaryDir>
#include <array>
#include <functional>
#include <memory>

namespace tessera::process {
namespace {

class Talkative : public testing::Test {
protected:
  /// Begins a program that does this instead of a world.
  void begin(const QByteArray& script) {
    const QString path = folder.filePath(QStringLiteral("world"));
    QFile file{path};
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("#!/bin/sh\n" + script);
    file.close();
    ASSERT_TRUE(file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
    world = std::make_unique<WorldProcess>(path);
    QObject::connect(world.get(), &WorldProcess::complained, [this](const QString& line) { said << line; });
    QObject::connect(world.get(), &WorldProcess::ready, [this] { isReady = true; });
    QObject::connect(world.get(), &WorldProcess::died, [this](const QString& sentence) { end = sentence; });
    world->begin({});
  }
  static bool until(const std::function<bool()>& condition) {
    const QDeadlineTimer patience{60'000};
    while (!condition() && !patience.hasExpired()) QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
    return condition();
  }

  int argc = 1;
  std::array<char, 5> name{"test"};
  std::array<char*, 2> argv{name.data(), nullptr};
  QCoreApplication application{argc, argv.data()};
  QTemporaryDir folder;
  std::unique_ptr<WorldProcess> world;
  QStringList said;
  QString end;
  bool isReady = false;
};

// The script waits for the answer to its half: what came of it has been read by then.
TEST_F(Talkative, isHeardLineByLineThoughALineComesInPieces) {
  begin(
      "printf 'a vehicle has \\303' >&2\necho '{\"port\": \"/dev/null\"}'\nread go\n"
      "printf '\\244nded\\nand the ' >&2\necho halves\nread go\necho 'machine is slow' >&2\nread quit\n");
  ASSERT_TRUE(until([&] { return isReady; }));
  EXPECT_EQ(said, QStringList{}) << "half a line is none yet";
  QStringList answers;
  QObject::connect(world.get(), &WorldProcess::answered, [&](const QString& line) { answers << line; });
  world->command("go");
  ASSERT_TRUE(until([&] { return answers.size() == 1; }));
  EXPECT_TRUE(until([&] { return said.size() == 1; }));
  EXPECT_EQ(said, QStringList{QStringLiteral("a vehicle has \u00E4nded")});
  world->command("go");
  EXPECT_TRUE(until([&] { return said.size() == 2; }));
  EXPECT_EQ(said.back(), "and the machine is slow");
}

TEST_F(Talkative, isQuotedToTheLastWordWhenItEnds) {
  begin("printf 'first\\nno line end' >&2\nexit 3\n");
  ASSERT_TRUE(until([&] { return !end.isEmpty(); }));
  EXPECT_EQ(said, (QStringList{"first", "no line end"}));
  EXPECT_TRUE(end.endsWith("It said: first no line end")) << end.toStdString();
}

}  // namespace
}  // namespace tessera::process
