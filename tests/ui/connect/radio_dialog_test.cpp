// The radio module's dialogue over a bench that answers when the test says so.
#include "ui/connect/radio_dialog.h"

#include <gtest/gtest.h>

#include <QTest>

#include "ui/connect/radio_rows.h"

namespace tessera::ui {
namespace {

class FakeBench : public RadioBench {
public:
  void read() override { ++reads; }
  void write(const link::E32Parameters& parameters) override { written.push_back(parameters); }
  void cancel() override { ++cancels; }
  void answer(const link::E32Parameters& parameters) { Q_EMIT found(parameters); }
  void fail(const QString& sentence) { Q_EMIT failed(sentence); }

  int reads = 0;
  int cancels = 0;
  std::vector<link::E32Parameters> written;
};

class RadioDialogTest : public testing::Test {
protected:
  void SetUp() override {
    dialog.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
  }
  QPushButton& button(const char* name) {
    auto* found = dialog.findChild<QPushButton*>(QLatin1String{name});
    if (found == nullptr) throw std::runtime_error{std::string{"no "} + name};
    return *found;
  }
  void click(const char* name) { QTest::mouseClick(&button(name), Qt::LeftButton); }
  Notice& result() { return *dialog.findChild<Notice*>("radioResult"); }
  QString cell(int row, int column) { return dialog.findChild<QTableWidget*>("radioTable")->item(row, column)->text(); }

  FakeBench bench;
  RadioDialog dialog{bench, floor::RadioSetup{}};
};

TEST_F(RadioDialogTest, BeforeReadingItShowsTheSiteAlone) {
  EXPECT_TRUE(cell(0, 2).startsWith("23"));
  EXPECT_FALSE(cell(0, 1).contains("23"));
}

TEST_F(RadioDialogTest, AModuleSetLikeTheSiteIsGood) {
  click("readModule");
  EXPECT_EQ(bench.reads, 1);
  EXPECT_FALSE(button("readModule").isEnabled());
  EXPECT_TRUE(button("cancelModule").isVisible());
  bench.answer({});
  EXPECT_EQ(result().tone(), Notice::Tone::Good);
  EXPECT_TRUE(button("readModule").isEnabled());
  EXPECT_FALSE(button("cancelModule").isVisible());
}

TEST_F(RadioDialogTest, ADifferenceIsMarkedAndWrittenAway) {
  click("readModule");
  link::E32Parameters other;
  other.channel = 4;
  other.power = 2;
  bench.answer(other);
  EXPECT_EQ(result().tone(), Notice::Tone::Warning);
  EXPECT_NE(cell(0, 1), cell(0, 2));
  click("writeModule");
  ASSERT_EQ(bench.written.size(), 1U);
  link::E32Parameters expected;
  expected.power = 2;  // what the module has is kept, as the site leaves it open
  EXPECT_EQ(bench.written.front(), expected);
  bench.answer(expected);
  EXPECT_EQ(result().tone(), Notice::Tone::Good);
  EXPECT_EQ(cell(0, 1), cell(0, 2));
}

TEST_F(RadioDialogTest, AModuleThatKeepsItsOwnIsToldAsAnError) {
  click("writeModule");
  link::E32Parameters other;
  other.airRate = 2;
  bench.answer(other);
  EXPECT_EQ(result().tone(), Notice::Tone::Error);
}

TEST_F(RadioDialogTest, AFailureShowsItsSentence) {
  click("readModule");
  bench.fail("The module does not answer. Are both jumpers off?");
  EXPECT_EQ(result().tone(), Notice::Tone::Error);
  EXPECT_EQ(result().text(), "The module does not answer. Are both jumpers off?");
  EXPECT_TRUE(button("readModule").isEnabled());
}

TEST_F(RadioDialogTest, CancelEndsTheWorkAndALateAnswerIsIgnored) {
  click("readModule");
  click("cancelModule");
  EXPECT_EQ(bench.cancels, 1);
  link::E32Parameters other;
  other.channel = 9;
  bench.answer(other);
  EXPECT_FALSE(cell(0, 1).contains("9 "));
  EXPECT_EQ(result().tone(), Notice::Tone::Info);
}

TEST_F(RadioDialogTest, ClosingCancels) {
  click("readModule");
  QTest::keyClick(&dialog, Qt::Key_Escape);
  EXPECT_EQ(bench.cancels, 1);
  EXPECT_FALSE(dialog.isVisible());
}

TEST_F(RadioDialogTest, AdviceStandsThereOnlyWhenThereIsSome) {
  auto* advice = dialog.findChild<Notice*>("radioAdvice");
  EXPECT_FALSE(advice->isVisible());
  dialog.setAdvice({"Frames of vehicle 3 arrive damaged."});
  EXPECT_TRUE(advice->isVisible());
  dialog.setAdvice({});
  EXPECT_FALSE(advice->isVisible());
}

TEST(RadioRows, TakesTheNextSlowerAirRateOfTheModule) {
  floor::RadioSetup site;
  site.airRate = 2400;
  EXPECT_EQ(RadioRows::wanted(site, 0).airRate, 2);
  site.airRate = 300;
  EXPECT_EQ(RadioRows::wanted(site, 7).airRate, 0);
  EXPECT_EQ(RadioRows::wanted(site, 7).power, 3);
}

}  // namespace
}  // namespace tessera::ui
