// Keys of a reader and keys of a person, told apart.
#include "ui/register/keyboard_reader.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

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
  QSignalSpy typed{&reader, &KeyboardReader::typed};
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
