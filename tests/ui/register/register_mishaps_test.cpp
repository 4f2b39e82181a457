// What goes wrong or is interrupted while registering, and what the panel says of it.
#include <algorithm>

#include "counter.h"
#include "keys_at.h"

namespace tessera::ui {
namespace {

TEST_F(Counter, registersNoPartOfAUid) {
  click("startScan");
  type("04A1B2C3D4E5F6");
  const auto second = registrar.place();
  test::keysAt(*QApplication::focusWidget(), "04A1B2C4", 5000);
  ASSERT_TRUE(QTest::qWaitFor([&] { return said("scanNotice").startsWith("Only a part"); }));
  test::keysAt(*QApplication::focusWidget(), "d4e5f6", 5700);
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  EXPECT_EQ(said("scanNotice"), "Only a part of a UID came: 04A1B2C4. Hold the card again.");
  EXPECT_EQ(registered(), 1U);
  EXPECT_EQ(registrar.place(), second);
  type("04A1B2C4D4E5F6");
  EXPECT_EQ(uids(0), (std::vector<std::string>{"04A1B2C3D4E5F6", "04A1B2C4D4E5F6"}));
}

TEST_F(Counter, takesAPartOfAUidBackThatAReaderWithoutEnterSent) {
  click("startScan");
  const auto first = registrar.place();
  test::keysAt(*QApplication::focusWidget(), "04A1B2C3", 5000);
  ASSERT_TRUE(QTest::qWaitFor([&] { return registered() == 1; }));
  test::keysAt(*QApplication::focusWidget(), "D4E5F6", 5700);
  ASSERT_TRUE(QTest::qWaitFor([&] { return registered() == 0; }));
  EXPECT_EQ(said("scanNotice"), "Only a part of a UID came: 04A1B2C3 was taken back. Hold the card again.");
  EXPECT_EQ(registrar.place(), first);
  test::keysAt(*QApplication::focusWidget(), "04A1B2C3D4E5F6", 8000);
  ASSERT_TRUE(QTest::qWaitFor([&] { return registered() == 1; }));
  EXPECT_EQ(uids(0), std::vector<std::string>{"04A1B2C3D4E5F6"});
}

TEST_F(Counter, saysWhatWasTakenBackOrSkipped) {
  startWithPort();
  auto* page = find("scanPage");
  for (const char* uid : {"04A1B2C3\r\n", "04A1B2C4\r\n", "04A1B2C5\r\n"}) bench.say(uid);
  EXPECT_EQ(said("scanNotice"), "Registered: 04A1B2C5");
  QTest::keyClick(page, Qt::Key_Backspace);
  EXPECT_EQ(said("scanNotice"), "Taken back: 04A1B2C5");
  const QString third = QStringLiteral("tag %1 of tile T-0001").arg(registrar.place()->tag + 1);
  QTest::keyClick(page, Qt::Key_Delete);
  EXPECT_EQ(said("scanNotice"), "Skipped: " + third);
  QTest::keyClick(page, Qt::Key_Backspace);
  EXPECT_EQ(said("scanNotice"), "Skipped no longer: " + third);
  bench.say("04A1B2C6\r\n");
  EXPECT_EQ(said("scanNotice"), "Registered: 04A1B2C6");
  document.undoStack().undo();
  EXPECT_EQ(said("scanNotice"), "Taken back: 04A1B2C6");
  document.undoStack().redo();
  EXPECT_FALSE(find<QLabel>("scanNotice")->isVisible());
}

TEST_F(Counter, readsAWholeFloorAnewWhoseTagsAreMadeUp) {
  const floor::NewFloor practice{"f", floor::usualTileTypes().front(), 2, 1, true};
  document.replace(floor::SiteMap::build(floor::layNewFloor(practice).value()).value(), {});
  startWithPort();
  EXPECT_EQ(said("scanTitle"), "All done");
  click("scanEnd");
  click("scanAgain");
  startWithPort();
  EXPECT_EQ(said("scanTitle"), "Tile T-0001");
  bench.say("04A1B2C3\r\n04A1B2C4\r\n");
  EXPECT_EQ(uids(0)[0], "04A1B2C3");
  EXPECT_EQ(uids(0)[1], "04A1B2C4");
  EXPECT_TRUE(said("scanCount").startsWith("2 of 16 read anew")) << said("scanCount").toStdString();
}

TEST_F(Counter, saysThatNothingIsLeftWhereAnImportFilledIt) {
  startWithPort();
  bench.say("04A1B2C3\r\n");
  click("scanEnd");
  ASSERT_TRUE(find<QPushButton>("goOnScanning")->isVisible());
  const auto fill = [&](std::size_t tags) {
    ASSERT_TRUE(document.edit("Import", [&](floor::Site& site) {
      for (std::size_t tile = 0; tile < site.tiles.size(); ++tile) {
        auto& uids = site.tiles[tile].uids;
        uids.resize(std::max(uids.size(), tags));
        for (std::size_t tag = 0; tag < tags; ++tag) {
          const QString uid = QStringLiteral("05A1B2%1").arg(16 * tile + tag, 2, 16, QLatin1Char('0'));
          if (uids[tag].empty()) uids[tag] = floor::TagUid::parse(uid.toStdString()).value();
        }
      }
    }));
  };
  fill(7);
  auto* text = find<QLabel>("goOnText");
  EXPECT_EQ(text->text(), "Registering stopped at tag 8 of tile T-0001.");
  fill(8);
  EXPECT_FALSE(find<QPushButton>("goOnScanning")->isVisible());
  EXPECT_FALSE(text->isVisible());
}

TEST_F(Counter, keepsItsButtonsInSightWhereThereIsLittleRoom) {
  startWithPort();
  panel.resize(420, 330);
  bench.say("this is no UID at all and takes two lines\r\n");
  for (const char* name : {"scanBack", "scanSkip", "scanPause", "scanEnd"}) {
    auto* button = find<QPushButton>(name);
    EXPECT_TRUE(QTest::qWaitFor([&] { return button->visibleRegion().boundingRect() == button->rect(); })) << name;
  }
}

TEST_F(Counter, saysWhenAReaderThatTypesGoesUnheard) {
  click("startScan");
  auto* deaf = find<QLabel>("scanDeaf");
  EXPECT_FALSE(deaf->isVisible());
  QApplication::setActiveWindow(nullptr);
  EXPECT_TRUE(deaf->isVisible());
  QApplication::setActiveWindow(&panel);
  EXPECT_FALSE(deaf->isVisible());
  click("scanEnd");
  startWithPort();
  QApplication::setActiveWindow(nullptr);
  EXPECT_FALSE(deaf->isVisible()) << "a port is heard whatever is in front";
}

TEST_F(Counter, givesTheTimeLeftInHoursWhereItIsLong) {
  EXPECT_EQ(ScanPage::timeText(Seconds{61.0}), "2 min");
  EXPECT_EQ(ScanPage::timeText(Seconds{1563.0 * 60.0}), "26 h 3 min");
}

}  // namespace
}  // namespace tessera::ui
