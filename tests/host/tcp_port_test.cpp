// TcpPort against a device server of Qt's own, on this machine.
#include "host/tcp_port.h"

#include <gtest/gtest.h>

#include <QTcpServer>
#include <array>
#include <memory>

#include "host/until.h"

namespace tessera::host {
namespace {

using namespace std::chrono_literals;
using test::until;

class TcpPortTest : public ::testing::Test {
protected:
  TcpPortTest() { server.listen(QHostAddress::LocalHost); }

  void make(std::chrono::milliseconds patience = 3000ms) { make("127.0.0.1", server.serverPort(), patience); }
  void make(const QString& host, quint16 number, std::chrono::milliseconds patience = 3000ms) {
    port = std::make_unique<TcpPort>(host, number, RetryPauses{20ms, 50ms}, nullptr, patience);
    QObject::connect(port.get(), &BytePort::opened, [this] { ++opened; });
    QObject::connect(port.get(), &BytePort::lost, [this](const Sentence& why) {
      ++lost;
      reason = why.english();
    });
    QObject::connect(port.get(), &BytePort::received, [this](const QByteArray& bytes) { heard += bytes; });
    port->open();
  }
  /// The server's end of the newest connection.
  QTcpSocket* accept() {
    until([this] { return server.hasPendingConnections(); });
    return server.nextPendingConnection();
  }
  bool says(const std::string& words) const { return reason.find(words) != std::string::npos; }

  QTcpServer server;
  std::unique_ptr<TcpPort> port;
  int opened = 0;
  int lost = 0;
  std::string reason;
  QByteArray heard;
};

constexpr std::array<std::uint8_t, 4> kBytes{0xA5, 0x00, 0x0D, 0xFF};

TEST_F(TcpPortTest, carriesBytesBothWaysAsTheyAre) {
  make();
  QTcpSocket* other = accept();
  ASSERT_TRUE(until([this] { return opened == 1; }));
  EXPECT_TRUE(port->write(kBytes));
  ASSERT_TRUE(until([&] { return other->bytesAvailable() == 4; }));
  EXPECT_EQ(other->readAll(), QByteArray("\xA5\x00\x0D\xFF", 4));
  other->write(QByteArray("\xFF\x0D\x00\x11", 4));
  ASSERT_TRUE(until([this] { return heard.size() == 4; }));
  EXPECT_EQ(heard, QByteArray("\xFF\x0D\x00\x11", 4));
}

TEST_F(TcpPortTest, tellsALossOnceAndConnectsAgainByItself) {
  make();
  for (int round = 1; round <= 3; ++round) {
    QTcpSocket* other = accept();
    ASSERT_TRUE(until([&] { return opened == round; }));
    const quint16 number = server.serverPort();
    server.close();  // as when the device server is switched off
    other->disconnectFromHost();
    ASSERT_TRUE(until([&] { return lost == round; }));
    EXPECT_TRUE(says("closed the connection")) << reason;
    until([] { return false; }, 0.2);
    EXPECT_EQ(lost, round) << "one word for one loss, though it is tried again and again";
    EXPECT_FALSE(port->isOpen());
    ASSERT_TRUE(server.listen(QHostAddress::LocalHost, number));
  }
  accept();
  EXPECT_TRUE(until([this] { return opened == 4; }));
}

TEST_F(TcpPortTest, countsAsLostWhenNobodyReads) {
  make();
  accept()->setReadBufferSize(1);  // Qt leaves the rest in the kernel, which takes what it has room for
  ASSERT_TRUE(until([this] { return opened == 1; }));
  const std::array<std::uint8_t, 58> frame{};
  int taken = 0;
  while (taken < 500'000 && port->write(frame)) {
    ++taken;
    QCoreApplication::processEvents();
  }
  EXPECT_EQ(lost, 1) << taken;
  EXPECT_TRUE(says("does not read")) << reason;
}

TEST_F(TcpPortTest, saysThatNobodyListensThere) {
  const quint16 number = server.serverPort();
  server.close();
  make("127.0.0.1", number);
  ASSERT_TRUE(until([this] { return lost == 1; }));
  EXPECT_TRUE(says("refuses the connection")) << reason;
}

TEST_F(TcpPortTest, saysThatTheNameIsUnknown) {
  make("no-such-host.invalid", 4001);
  ASSERT_TRUE(until([this] { return lost == 1; }, 30));
  EXPECT_TRUE(says("no host of this name") || says("does not answer")) << reason;
}

// 192.0.2.0/24 belongs to nobody (RFC 5737): its packets vanish, or the machine has no way there.
TEST_F(TcpPortTest, doesNotWaitForEverForAnAnswer) {
  make("192.0.2.1", 4001, 200ms);
  ASSERT_TRUE(until([this] { return lost == 1; }));
  EXPECT_TRUE(says("does not answer") || says("network") || says("refuses")) << reason;
  EXPECT_FALSE(port->isOpen());
}

TEST_F(TcpPortTest, writesNothingWhileClosedAndStaysClosedWhenItWasClosed) {
  make();
  QTcpSocket* other = accept();
  ASSERT_TRUE(until([this] { return opened == 1; }));
  port->close();
  EXPECT_FALSE(port->write(kBytes));
  EXPECT_TRUE(until([&] { return other->state() == QAbstractSocket::UnconnectedState; }));
  until([] { return false; }, 0.2);
  EXPECT_EQ(lost, 0);
  EXPECT_EQ(opened, 1);
}

TEST_F(TcpPortTest, hasNoLines) {
  make();
  accept();
  ASSERT_TRUE(until([this] { return opened == 1; }));
  EXPECT_FALSE(port->setLines(true, true));
}

}  // namespace
}  // namespace tessera::host
