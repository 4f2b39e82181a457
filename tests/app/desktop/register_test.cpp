// Two tiles are registered with a reader at a port, by a person who errs, is interrupted and loses the reader.
#include <QAction>

#include "app/desktop/registering.h"
#include "app/tessera/keeper.h"

namespace tessera::desktop {
namespace {

TEST_F(Registering, goesOverTwoTilesWithADuplicateASkipAndAStepBack) {
  ASSERT_NO_FATAL_FAILURE(start());
  for (const char* uid : {"04000001", "04000002", "04000003"}) scan(uid);
  say("04000003");  // the card still lies there
  say("04000001");
  ASSERT_TRUE(until([&] { return find("scanWhere")->isVisible(); }));
  EXPECT_EQ(said("scanNotice"),
            "Tag 04000001 is registered already, as tag 1 of this tile. Move it here, or read the whole tile anew?");
  QTest::mouseClick(find("scanWhere"), Qt::LeftButton);
  EXPECT_EQ(registered(), 3U);

  const auto dead = registrar().place();
  pressOnFloor(Qt::Key_Delete);
  scan("04000004");
  const auto last = registrar().place();
  scan("040000FF");  // a slip
  pressOnFloor(Qt::Key_Backspace);
  EXPECT_EQ(registrar().place(), last);
  scan("04000005");
  for (int n = 6; n <= 15; ++n) scan("0400000" + std::string(1, "0123456789ABCDEF"[n]));
  EXPECT_EQ(said("scanTitle"), "All done");
  QTest::mouseClick(find("scanSkipped"), Qt::LeftButton);
  EXPECT_EQ(registrar().place(), dead);
  scan("04000010");

  std::size_t found = 0;
  for (const auto& tile : window->document().site().tiles)
    for (const auto& uid : tile.uids) found += window->document().map()->find(uid).has_value() ? 1 : 0;
  EXPECT_EQ(found, 16U);
  const auto done = window->document().site();
  trigger("undo");
  EXPECT_NE(window->document().site(), done);
  trigger("redo");
  EXPECT_EQ(window->document().site(), done);
}

TEST_F(Registering, bringsTheNextPlaceIntoViewAndLeavesByEscape) {
  ASSERT_NO_FATAL_FAILURE(start());
  for (int n = 1; n <= 9; ++n) {
    scan("0400000" + std::to_string(n));
    const QPointF at = window->canvas().view().toPixel(*registrar().point());
    EXPECT_TRUE(window->canvas().rect().contains(at.toPoint()));
    EXPECT_GE(window->canvas().view().scale(), 150.0);
  }
  window->canvas().setFocus();
  pressOnFloor(Qt::Key_Escape);
  EXPECT_EQ(registrar().state(), ui::Registrar::State::Idle);
  EXPECT_FALSE(find<QAction>("registerTags")->isChecked());
}

TEST_F(Registering, takesTheReaderUpAgainWhenItWasUnplugged) {
  ASSERT_NO_FATAL_FAILURE(start());
  scan("04000001");
  reader.reset();
  ASSERT_TRUE(until([&] { return registrar().contact() == Contact::Lost; }));
  EXPECT_TRUE(said("scanNotice").contains(QString::fromStdString(port()))) << said("scanNotice").toStdString();
  plugIn();
  ASSERT_TRUE(until([&] { return registrar().contact() == Contact::Open; }));
  scan("04000002");
}

TEST_F(Registering, goesOnAtTheSameTagAfterTheProgramDied) {
  ASSERT_NO_FATAL_FAILURE(start());
  scan("04000001");
  pressOnFloor(Qt::Key_Delete);
  scan("04000002");
  const auto place = registrar().place();
  ASSERT_NO_FATAL_FAILURE(dieAndGoOn());
  EXPECT_EQ(registrar().place(), place);
  EXPECT_EQ(registrar().registration()->progress().skipped, 1U);
  ASSERT_TRUE(until([&] { return registrar().contact() == Contact::Open; })) << "the reader is remembered as well";
  scan("04000003");
}

TEST_F(Registering, readsATileInAnotherOrderOverTheProgramsDeath) {
  ASSERT_NO_FATAL_FAILURE(start());
  for (const char* uid : {"04000001", "04000002", "04000003"}) scan(uid);
  say("04000002");
  ASSERT_TRUE(until([&] { return find("scanAnew")->isVisible(); }));
  QTest::mouseClick(find("scanAnew"), Qt::LeftButton);
  EXPECT_EQ(registered(), 0U);
  for (const char* uid : {"04000003", "04000001"}) scan(uid);
  say("04000003");
  ASSERT_TRUE(until([&] { return find("scanExchange")->isVisible(); }));
  QTest::mouseClick(find("scanExchange"), Qt::LeftButton);
  const auto place = registrar().place();
  ASSERT_NO_FATAL_FAILURE(dieAndGoOn());
  ASSERT_TRUE(until([&] { return registrar().contact() == Contact::Open; }));
  EXPECT_EQ(registrar().place(), place);
  scan("04000002");
}

TEST_F(Registering, goesOnWhereItWasAfterTheSiteGotAnotherName) {
  ASSERT_NO_FATAL_FAILURE(start());
  scan("04000001");
  pressOnFloor(Qt::Key_Delete);
  const auto place = registrar().place();
  QTest::mouseClick(find("scanEnd"), Qt::LeftButton);
  nameTheFile(home.filePath("other.tessera.json"));
  ASSERT_TRUE(window->files().saveAs());
  QTest::mouseClick(find("goOnScanning"), Qt::LeftButton);
  EXPECT_EQ(registrar().place(), place);
  EXPECT_EQ(registrar().registration()->progress().skipped, 1U);
}

}  // namespace
}  // namespace tessera::desktop
