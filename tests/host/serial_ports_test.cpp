#include "host/serial_ports.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

namespace tessera::host {
namespace {

TEST(SerialPorts, leavesOutNamesBehindWhichThereIsNoChip) {
  const QTemporaryDir folder;
  const auto tell = [&](const char* name, const char* type) {
    ASSERT_TRUE(QDir{folder.path()}.mkdir(name));
    QFile file{folder.filePath(QStringLiteral("%1/type").arg(name))};
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(type);
  };
  tell("ttyS0", "4\n");
  tell("ttyS1", "0\n");
  ASSERT_TRUE(QDir{folder.path()}.mkdir("ttyUSB0"));
  EXPECT_TRUE(isThere("ttyS0", folder.path()));
  EXPECT_FALSE(isThere("ttyS1", folder.path()));
  EXPECT_TRUE(isThere("ttyUSB0", folder.path())) << "an adapter says nothing of a chip";
  EXPECT_TRUE(isThere("COM3", folder.path())) << "of other systems' ports nothing is said at all";
}

}  // namespace
}  // namespace tessera::host
