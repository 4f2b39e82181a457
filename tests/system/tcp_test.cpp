// The radio behind a device server: socat joins the world's pseudo terminal to a TCP port, as ser2net would a real
// serial port, and the supervisor drives over the connection.
#include <gtest/gtest.h>
#include <signal.h>

#include <QTcpServer>
#include <QThread>

#include "system/supervision.h"
#include "system/world.h"

namespace tessera::system_test {
namespace {

using supervisor::EventKind;

const std::string kPaper = TESSERA_SITES "/paper.tessera.json";
constexpr MetresPerSecond kSpeed{0.2};

class DeviceServer {
public:
  explicit DeviceServer(std::string device) : device_{std::move(device)} {
    QTcpServer free;  // a port number that nobody uses now
    free.listen(QHostAddress::LocalHost);
    number_ = free.serverPort();
  }
  [[nodiscard]] std::string port() const { return "tcp://127.0.0.1:" + std::to_string(number_); }
  void switchOn() {
    program_ = std::make_unique<Program>(
        TESSERA_SOCAT, std::vector<std::string>{"TCP-LISTEN:" + std::to_string(number_) + ",bind=127.0.0.1,reuseaddr",
                                                "OPEN:" + device_ + ",raw,echo=0"});
  }
  void switchOff() { program_.reset(); }

private:
  std::string device_;
  quint16 number_ = 0;
  std::unique_ptr<Program> program_;
};

TEST(DeviceServerTest, carriesADriveAndItsLossAndReturnAreTold) {
  const QTemporaryDir folder;
  World world{folder, kPaper, {"--kind", "native"}};
  ASSERT_NE(world.port(), "") << world.program().errors();
  DeviceServer server{world.port()};
  server.switchOn();
  Supervision supervision{kPaper, server.port()};
  ASSERT_TRUE(supervision.drive(kSpeed, Metres{0.2})) << supervision.sentences();

  // The first connection may have come before socat listened: then one loss and one return are told already.
  const int returns = supervision.told(EventKind::PortLost, true);
  const Seconds cut = host::steadyNow();
  server.switchOff();
  const std::string loss = server.port() + " is lost: the device server has closed the connection.";
  EXPECT_TRUE(supervision.until([&] { return supervision.sentences().find(loss) != std::string::npos; }))
      << supervision.sentences();
  EXPECT_LT(world.movedOnFor(cut), Seconds{5}) << "it stops by itself";
  const Point stood = world.where();

  server.switchOn();
  EXPECT_TRUE(supervision.until([&] { return supervision.told(EventKind::PortLost, true) > returns; }))
      << supervision.sentences();
  EXPECT_TRUE(supervision.until([&] {
    return supervision.view().finished || distance(world.where(), stood) > Metres{0.25};
  })) << supervision.sentences();
}

TEST(DeviceServerTest, carriesAWholeDriveOfTheCommandLine) {
  const QTemporaryDir folder;
  World world{folder, kPaper, {"--kind", "native"}};
  ASSERT_NE(world.port(), "") << world.program().errors();
  DeviceServer server{world.port()};
  server.switchOn();
  // The first connection may come before socat listens; the port is then tried again.
  Program cli{TESSERA_CLI,
              {"drive", kPaper, "--port", server.port(), "--drive", "1=paper", "--speed", "0.3", "--json"}};
  EXPECT_EQ(cli.exitCode(), 0) << cli.errors();
  EXPECT_NE(cli.output().find("\"finished\": true"), std::string::npos) << cli.output();
}

}  // namespace
}  // namespace tessera::system_test
