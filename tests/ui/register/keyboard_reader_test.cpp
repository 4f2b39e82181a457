// Keys of a reader and keys of a person, told apart.
#include "ui/register/keyboard_reader.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

#include "keys_at.h"

namespace tessera::ui {
namespace {

class KeysOfAReader : public testing::Test {
protected:
  void SetUp() override {
    field.show();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&field));
    field.setFocus();
    reader.setListening(true);
  }

  QLineEdit field;
  KeyboardReader reader;
  void read(const char* line) {
    QTest::keyClicks(&field, line);
    QTest::keyClick(&field, Qt::Key_Return);
  }
  void keysAt(const char* keys, quint64 ms) { test::keysAt(field, keys, ms); }
  [[nodiscard]] QStringList said() const {
    QStringList all;
    for (const auto& call : typed) all << call[0].toString();
    for (const auto& call : torn) all << (call[1].toBool() ? "not " : "part ") + call[0].toString();
    return all;
  }

  QSignalSpy typed{&reader, &KeyboardReader::typed};
  QSignalSpy torn{&reader, &KeyboardReader::torn};
};

TEST_F(KeysOfAReader, becomeAReadAndReachNoField) {
  QSignalSpy entered{&field, &QLineEdit::returnPressed};
  QTest::keyClicks(&field, "04a1B2c3");
  QTest::keyClick(&field, Qt::Key_Return);
  QTest::keyClicks(&field, "04:A1:B2:C4");
  QTest::keyClick(&field, Qt::Key_Enter, Qt::KeypadModifier);
  ASSERT_EQ(typed.count(), 2);
  EXPECT_EQ(typed[0][0].toString(), "04a1B2c3");
  EXPECT_EQ(typed[1][0].toString(), "04:A1:B2:C4");
  EXPECT_EQ(field.text(), "");
  EXPECT_EQ(entered.count(), 0);
}

TEST_F(KeysOfAReader, areAReadWithoutEnterAsWell) {
  QTest::keyClicks(&field, "0077705923");
  EXPECT_TRUE(typed.wait(5000));
  EXPECT_EQ(typed[0][0].toString(), "0077705923");
  EXPECT_EQ(field.text(), "");
}

TEST_F(KeysOfAReader, areNoReadWithoutEnterOnceEnterWasSent) {
  read("04A1B2C3D4E5F6");
  keysAt("04A1B2C4", 5000);
  ASSERT_TRUE(torn.wait(5000));
  keysAt("d4e5f6", 5700);
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_EQ(said(), (QStringList{"04A1B2C3D4E5F6", "part 04A1B2C4"})) << "the rest is told of no more";
  read("04A1B2C4D4E5F6");
  EXPECT_EQ(typed.count(), 2) << "the card held again";
  EXPECT_EQ(field.text(), "");
}

TEST_F(KeysOfAReader, areNoReadWhereTheRestIsAsLongAsOne) {
  read("04A1B2C3D4E5F6");
  keysAt("04A1B2", 5000);
  ASSERT_TRUE(QTest::qWaitFor([&] { return field.text() == "04A1B2"; })) << "a person's, for all that it knows";
  keysAt("C3D4E5F6", 5700);
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_EQ(said(), (QStringList{"04A1B2C3D4E5F6", "part C3D4E5F6"}));
}

TEST_F(KeysOfAReader, areOneReadOverAStall) {
  read("04A1B2C3");
  QTest::keyClicks(&field, "04A1B2C3");
  QTest::qWait(KeyboardReader::kPauseMs + 60);
  read("D4E5F6");
  EXPECT_EQ(said(), (QStringList{"04A1B2C3", "04A1B2C3D4E5F6"}));
}

TEST_F(KeysOfAReader, areOneReadOverAStallOfTheProgram) {
  QTest::keyClicks(&field, "04A1B2C3");
  // The keys wait while the program is busy, as behind the window system's socket: whichever turn comes first.
  QTimer late;
  late.setSingleShot(true);
  QObject::connect(&late, &QTimer::timeout, [&] { read("D4E5F6"); });
  late.start(KeyboardReader::kReadPauseMs + 10);
  QTest::qSleep(KeyboardReader::kReadPauseMs + 100);
  ASSERT_TRUE(typed.wait(5000));
  EXPECT_EQ(said(), QStringList{"04A1B2C3D4E5F6"});
}

TEST_F(KeysOfAReader, areTwoReadsByTheirOwnTimesWhenTheyCameAtOnce) {
  keysAt("04A1B2C3", 5000);
  keysAt("04A1B2C4", 6500);
  ASSERT_TRUE(QTest::qWaitFor([&] { return typed.count() == 2; }));
  EXPECT_EQ(said(), (QStringList{"04A1B2C3", "04A1B2C4"}));
}

TEST_F(KeysOfAReader, areTakenBackWhereTheRestFollows) {
  keysAt("04A1B2C3", 5000);
  ASSERT_TRUE(typed.wait(5000));
  keysAt("D4E5F6", 5700);
  ASSERT_TRUE(torn.wait(5000));
  EXPECT_EQ(said(), (QStringList{"04A1B2C3", "not 04A1B2C3"}));
  EXPECT_EQ(field.text(), "");
}

TEST_F(KeysOfAReader, areTakenBackWhereItSendsEnterAfterAll) {
  keysAt("04A1B2C3", 5000);
  ASSERT_TRUE(typed.wait(5000));
  keysAt("D4E5F6", 5700);
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_EQ(said(), (QStringList{"04A1B2C3", "not 04A1B2C3"}));
  read("04A1B2C3D4E5F6");
  EXPECT_EQ(typed.count(), 2);
}

TEST_F(KeysOfAReader, areTheNextCardsWhereTheyAreAsMany) {
  for (const char* uid : {"04A1B2C3", "04A1B2C4", "04A1B2C5"}) {
    QTest::keyClicks(&field, uid);
    ASSERT_TRUE(typed.wait(5000));
  }
  EXPECT_EQ(said(), (QStringList{"04A1B2C3", "04A1B2C4", "04A1B2C5"}));
}

TEST_F(KeysOfAReader, leaveAPersonsKeysToTheirField) {
  QTest::keyClick(&field, 'a');
  EXPECT_TRUE(QTest::qWaitFor([&] { return field.text() == "a"; }));
  QTest::keyClick(&field, 'x');
  EXPECT_EQ(field.text(), "ax");
  QTest::keyClick(&field, '1');
  QTest::keyClick(&field, 'z');
  EXPECT_EQ(field.text(), "ax1z") << "another key lets the held one go first";
  QTest::keyClick(&field, '2');
  QTest::keyClick(&field, Qt::Key_Backspace);
  EXPECT_EQ(field.text(), "ax1z");
  QSignalSpy entered{&field, &QLineEdit::returnPressed};
  QTest::keyClick(&field, '3');
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_EQ(field.text(), "ax1z3");
  EXPECT_EQ(entered.count(), 1);
  EXPECT_EQ(typed.count(), 0);
}

TEST_F(KeysOfAReader, leaveShortcutsAlone) {
  field.setText("words");
  QTest::keyClick(&field, Qt::Key_A, Qt::ControlModifier);
  EXPECT_EQ(field.selectedText(), "words");
}

TEST_F(KeysOfAReader, areNobodysBusinessWhenItDoesNotListen) {
  QTest::keyClicks(&field, "04");
  reader.setListening(false);
  EXPECT_EQ(field.text(), "04") << "what was held back is let go";
  QTest::keyClicks(&field, "a1b2c3");
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_EQ(field.text(), "04a1b2c3");
  EXPECT_EQ(typed.count(), 0);
}

TEST_F(KeysOfAReader, areHeldBackFromAFieldThatGoesAway) {
  auto* other = new QLineEdit;
  other->show();
  QTest::keyClicks(other, "04");
  delete other;
  EXPECT_TRUE(QTest::qWaitFor([&] { return typed.count() == 0; }));
  QTest::keyClicks(&field, "x");
  EXPECT_EQ(field.text(), "x");
}

}  // namespace
}  // namespace tessera::ui
