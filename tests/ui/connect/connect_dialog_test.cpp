// The connection dialogue by mouse and by key.
#include "ui/connect/connect_dialog.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>

namespace tessera::ui {
namespace {

using Kind = ConnectionChoice::Kind;

class ConnectDialogTest : public testing::Test {
protected:
  void SetUp() override {
    dialog.show();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&dialog));
  }
  template <class W>
  W& at(const char* name) {
    auto* found = dialog.findChild<W*>(QLatin1String{name});
    if (found == nullptr) throw std::runtime_error{std::string{"no "} + name};
    return *found;
  }
  void choose(const char* kind) { QTest::mouseClick(&at<QRadioButton>(kind), Qt::LeftButton, {}, QPoint{8, 8}); }
  void press() { QTest::mouseClick(&at<QPushButton>("connectButton"), Qt::LeftButton); }
  QString complaint() { return at<Notice>("complaint").text(); }

  ConnectDialog dialog;
};

TEST_F(ConnectDialogTest, OffersTheFirstFreePort) {
  dialog.setPorts({{"/dev/ttyS0", "", true}, {"/dev/ttyUSB0", "CP2102", false}});
  press();
  EXPECT_EQ(dialog.result(), QDialog::Accepted);
  EXPECT_EQ(dialog.choice().kind, Kind::Serial);
  EXPECT_EQ(dialog.choice().port, "/dev/ttyUSB0");
}

TEST_F(ConnectDialogTest, TakesThePathOfATerminalThatWasTyped) {
  auto& field = at<QComboBox>("portField");
  field.setFocus();
  QTest::keyClicks(&field, "/dev/pts/7");
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_EQ(dialog.result(), QDialog::Accepted);
  EXPECT_EQ(dialog.choice().port, "/dev/pts/7");
}

TEST_F(ConnectDialogTest, ChoosingFromTheListTakesTheNameWithoutItsDescription) {
  dialog.setPorts({{"/dev/ttyUSB0", "CP2102", false}, {"/dev/ttyUSB1", "FTDI", false}});
  auto& field = at<QComboBox>("portField");
  field.setFocus();
  QTest::keyClick(&field, Qt::Key_Down);
  EXPECT_EQ(field.currentText(), "/dev/ttyUSB1");
}

TEST_F(ConnectDialogTest, WithoutAPortItSaysSoAndStays) {
  press();
  EXPECT_TRUE(dialog.isVisible());
  EXPECT_FALSE(complaint().isEmpty());
  QTest::keyClicks(&at<QComboBox>("portField"), "x");
  EXPECT_TRUE(complaint().isEmpty());
}

TEST_F(ConnectDialogTest, RefreshAsksForPortsAndKeepsWhatWasTyped) {
  QSignalSpy refresh{&dialog, &ConnectDialog::refreshRequested};
  at<QComboBox>("portField").setEditText("/dev/pts/3");
  QTest::mouseClick(&at<QToolButton>("refreshPorts"), Qt::LeftButton);
  EXPECT_EQ(refresh.count(), 1);
  dialog.setPorts({{"/dev/ttyUSB0", "", false}});
  EXPECT_EQ(at<QComboBox>("portField").currentText(), "/dev/pts/3");
}

TEST_F(ConnectDialogTest, TakesTheSitesBaudUnlessAnotherWasChosen) {
  dialog.setSiteBaud(9600);
  EXPECT_EQ(dialog.choice().baud, 9600);
  auto& baud = at<QComboBox>("baudField");
  baud.setFocus();
  QTest::keyClick(&baud, Qt::Key_Down);
  EXPECT_EQ(dialog.choice().baud, 19200);
  dialog.setSiteBaud(1200);
  EXPECT_EQ(dialog.choice().baud, 19200);
}

TEST_F(ConnectDialogTest, ANetworkPortNeedsAHost) {
  choose("tcpKind");
  press();
  EXPECT_TRUE(dialog.isVisible());
  EXPECT_FALSE(complaint().isEmpty());
  auto& host = at<QLineEdit>("hostField");
  EXPECT_TRUE(host.hasFocus());
  QTest::keyClicks(&host, "http://gate");
  press();
  EXPECT_TRUE(dialog.isVisible());
  host.clear();
  QTest::keyClicks(&host, "gate.local");
  at<QSpinBox>("tcpPortField").setValue(5000);
  press();
  EXPECT_EQ(dialog.result(), QDialog::Accepted);
  EXPECT_EQ(dialog.choice().kind, Kind::Tcp);
  EXPECT_EQ(dialog.choice().host, "gate.local");
  EXPECT_EQ(dialog.choice().tcpPort, 5000);
}

TEST_F(ConnectDialogTest, TheDemoWorldNeedsNothing) {
  choose("demoKind");
  EXPECT_FALSE(at<QComboBox>("portField").isEnabled());
  press();
  EXPECT_EQ(dialog.result(), QDialog::Accepted);
  EXPECT_EQ(dialog.choice().kind, Kind::Demo);
}

TEST_F(ConnectDialogTest, RemembersTheLastChoice) {
  const ConnectionChoice last{Kind::Tcp, "/dev/ttyUSB3", 115200, "gate", 4002};
  dialog.setChoice(last);
  EXPECT_EQ(dialog.choice(), last);
}

TEST_F(ConnectDialogTest, EscapeGivesUp) {
  QTest::keyClick(&dialog, Qt::Key_Escape);
  EXPECT_EQ(dialog.result(), QDialog::Rejected);
  EXPECT_FALSE(dialog.isVisible());
}

}  // namespace
}  // namespace tessera::ui
