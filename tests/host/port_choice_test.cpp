#include "host/port_choice.h"

#include <gtest/gtest.h>

#include "host/serial_port.h"
#include "host/tcp_port.h"

namespace tessera::host {
namespace {

TEST(PortChoice, takesASerialDeviceWithTheBaudGiven) {
  for (const char* name : {"/dev/ttyUSB0", "COM3", "/dev/pts/4"}) {
    const auto choice = PortChoice::parse(QString{name}, 9600);
    ASSERT_TRUE(choice);
    EXPECT_EQ(choice->to, (std::variant<PortChoice::Serial, PortChoice::Tcp>{PortChoice::Serial{name, 9600}}));
    EXPECT_EQ(choice->text(), name);
  }
}

TEST(PortChoice, takesADeviceServerByNameOrAddress) {
  const std::pair<const char*, PortChoice::Tcp> cases[]{
      {"tcp://192.168.1.20:4001", {"192.168.1.20", 4001}},
      {"TCP://radio.plant.local:23", {"radio.plant.local", 23}},
      {" tcp://[fe80::1]:65535 ", {"fe80::1", 65535}},
  };
  for (const auto& [words, wanted] : cases) {
    const auto choice = PortChoice::parse(QString{words}, 115200);
    ASSERT_TRUE(choice) << words;
    ASSERT_TRUE(std::holds_alternative<PortChoice::Tcp>(choice->to)) << words;
    EXPECT_EQ(std::get<PortChoice::Tcp>(choice->to), wanted) << words;
    EXPECT_EQ(PortChoice::parse(choice->text(), 115200), choice) << "its text is taken again";
  }
}

TEST(PortChoice, saysWhatIsWrongWithADeviceServersName) {
  for (const char* words :
       {"tcp://", "tcp://radio", "tcp://radio:", "tcp://:4001", "tcp://radio:0", "tcp://radio:65536", "tcp://radio:40x",
        "tcp://ra dio:4001", "tcp://fe80::1:4001", "tcp://radio:4001/"}) {
    const auto choice = PortChoice::parse(QString{words}, 115200);
    ASSERT_FALSE(choice) << words;
    EXPECT_NE(choice.error().sentence.english().find(words), std::string::npos) << choice.error().sentence;
    EXPECT_NE(choice.error().sentence.english().find("tcp://192.168.1.20:4001"), std::string::npos)
        << "shows how it is done";
  }
  EXPECT_FALSE(PortChoice::parse(" ", 115200));
}

TEST(PortChoice, makesThePortThatItNames) {
  const auto serial = makePort(PortChoice{PortChoice::Serial{"/dev/ttyUSB0", 9600}, {}});
  EXPECT_NE(dynamic_cast<SerialPort*>(serial.get()), nullptr);
  EXPECT_EQ(serial->name(), "/dev/ttyUSB0");
  const auto tcp = makePort(PortChoice{PortChoice::Tcp{"radio", 4001}, {}});
  EXPECT_NE(dynamic_cast<TcpPort*>(tcp.get()), nullptr);
  EXPECT_EQ(tcp->name(), "tcp://radio:4001");
}

TEST(PortChoice, changesTheBaudOfASerialDeviceAlone) {
  const PortChoice serial{PortChoice::Serial{"COM3", 115200}, {}};
  EXPECT_EQ(std::get<PortChoice::Serial>(serial.atBaud(9600).to).baud, 9600);
  const PortChoice tcp{PortChoice::Tcp{"radio", 4001}, {}};
  EXPECT_EQ(tcp.atBaud(9600), tcp);
}

}  // namespace
}  // namespace tessera::host
