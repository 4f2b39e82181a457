// Registering by reader and by hand, from Start to the last tag.
#include "counter.h"

namespace tessera::ui {
namespace {

TEST_F(Counter, registersTheTagsOfTwoTilesByAReaderThatTypes) {
  click("startScan");
  ASSERT_EQ(registrar.contact(), Registrar::Contact::Keyboard);
  for (int n = 0; n < 16; ++n) type(QStringLiteral("04A1B2%1").arg(n, 2, 16, QLatin1Char('0')).toLatin1().constData());
  EXPECT_EQ(registered(), 16U);
  EXPECT_EQ(said("scanTitle"), "All done");
  EXPECT_EQ(document.undoStack().count(), 16);
  EXPECT_FALSE(memory.course_) << "there is nothing to go on with";
}

TEST_F(Counter, registersByASerialReaderAndTellsWhichIsNext) {
  startWithPort();
  EXPECT_EQ(bench.opens, QStringList{"/dev/ttyTEST0 at 9600"});
  EXPECT_EQ(said("scanTitle"), "Tile T-0001");
  EXPECT_EQ(said("scanDetail"), "Tag 1 of 8");
  bench.say("04A1B2C3\r\n04A1");
  bench.say("B2C4\r\n");
  EXPECT_EQ(uids(0), (std::vector<std::string>{"04A1B2C3", "04A1B2C4"}));
  EXPECT_TRUE(said("scanNotice").contains("04A1B2C4"));
  EXPECT_TRUE(said("scanCount").startsWith("2 of 16")) << said("scanCount").toStdString();
  EXPECT_EQ(find<TilePicture>("tilePicture")->flashing(), TilePicture::Flash::Good);
}

TEST_F(Counter, ignoresTheSameCardAgainAndRefusesOneInUse) {
  startWithPort();
  bench.say("04A1B2C3\r\n04A1B2C3\r\n04A1B2C3\r\n");
  EXPECT_EQ(registered(), 1U);
  EXPECT_FALSE(find<QPushButton>("scanWhere")->isVisible());
  for (int n = 4; n <= 10; ++n) bench.say(QStringLiteral("04A1B2%1\n").arg(n, 2, 10, QLatin1Char('0')).toLatin1());
  bench.say("04A1B2C3\r\n");
  EXPECT_EQ(registered(), 8U);
  EXPECT_EQ(said("scanNotice"), "Tag 04A1B2C3 is registered already, as tag 1 of tile \"T-0001\".");
  EXPECT_FALSE(find<QPushButton>("scanExchange")->isVisible());
  EXPECT_EQ(find<TilePicture>("tilePicture")->flashing(), TilePicture::Flash::Bad);
  std::optional<scan::PlaceName> shown;
  QObject::connect(&panel, &RegisterPanel::showRequested, &panel, [&](const scan::PlaceName& p) { shown = p; });
  click("scanWhere");
  EXPECT_EQ(shown, (scan::PlaceName{"T-0001", 0}));
  EXPECT_EQ(registrar.place()->serial, "T-0002") << "the walk stays where it is";
  bench.say("04A1B2C5\r\n");
  EXPECT_FALSE(find<QPushButton>("scanWhere")->isVisible());
}

TEST_F(Counter, goesBackSkipsAndMovesByKey) {
  startWithPort();
  auto* page = find("scanPage");
  bench.say("04A1B2C3\r\n");
  const auto second = registrar.place();
  QTest::keyClick(page, Qt::Key_Delete);
  EXPECT_TRUE(said("scanCount").contains("1 skipped"));
  bench.say("04A1B2C4\r\n");
  QTest::keyClick(page, Qt::Key_Backspace);
  QTest::keyClick(page, Qt::Key_Backspace);
  EXPECT_EQ(registrar.place(), second);
  QTest::keyClick(page, Qt::Key_Backspace);
  EXPECT_EQ(registered(), 0U);
  EXPECT_TRUE(document.site().tiles[0].uids.empty());
  QTest::keyClick(page, Qt::Key_PageDown);
  EXPECT_EQ(registrar.place(), second);
  QTest::keyClick(page, Qt::Key_PageUp);
  EXPECT_NE(registrar.place(), second);
}

TEST_F(Counter, takesTheStepsOfUndoAndRedoAlong) {
  startWithPort();
  const floor::Site empty = document.site();
  const auto first = registrar.place();
  bench.say("04A1B2C3\r\n04A1B2C4\r\n");
  const auto third = registrar.place();
  const floor::Site two = document.site();
  EXPECT_EQ(document.undoStack().undoText(), "Register tag 2 of tile T-0001");
  document.undoStack().undo();
  document.undoStack().undo();
  EXPECT_EQ(document.site(), empty);
  EXPECT_EQ(registrar.place(), first);
  document.undoStack().redo();
  document.undoStack().redo();
  EXPECT_EQ(document.site(), two);
  EXPECT_EQ(registrar.place(), third);
}

TEST_F(Counter, countsNoReadWhilePaused) {
  startWithPort();
  click("scanPause");
  bench.say("04A1B2C3\r\n");
  EXPECT_EQ(registered(), 0U);
  EXPECT_TRUE(said("scanDetail").contains("paused"));
  click("scanPause");
  bench.say("04A1B2C4\r\n");
  EXPECT_EQ(registered(), 1U);
}

TEST_F(Counter, tellsALostPortAndGoesOnWhenItIsBack) {
  startWithPort();
  bench.say("04A1");
  Q_EMIT bench.lost("The reader is gone.");
  EXPECT_EQ(said("scanNotice"), "The reader is gone.");
  EXPECT_EQ(said("scanContact"), "Reader: waiting for /dev/ttyTEST0");
  Q_EMIT bench.opened();
  EXPECT_FALSE(find<QLabel>("scanNotice")->isVisible());
  bench.say("04A1B2C4\r\n");
  EXPECT_EQ(uids(0), std::vector<std::string>{"04A1B2C4"}) << "half a line of before is forgotten";
}

TEST_F(Counter, goesOnWhereItStoodAfterTheProgramEnded) {
  startWithPort();
  bench.say("04A1B2C3\r\n");
  QTest::keyClick(find("scanPage"), Qt::Key_Delete);
  const auto place = registrar.place();
  click("scanEnd");
  EXPECT_EQ(registrar.state(), Registrar::State::Idle);
  Registrar after{document, bench, memory};
  RegisterPanel again{after};
  again.show();
  auto* goOn = again.findChild<QPushButton*>("goOnScanning");
  ASSERT_TRUE(goOn->isVisible());
  QTest::mouseClick(goOn, Qt::LeftButton);
  EXPECT_EQ(after.place(), place);
  EXPECT_EQ(after.registration()->progress().skipped, 1U);
}

TEST_F(Counter, registersOneTileAloneAndClearsIt) {
  click("scanOneTile");
  EXPECT_FALSE(find<QPushButton>("startScan")->isEnabled());
  QTest::keyClicks(find("scanTile"), "T-0009");
  EXPECT_EQ(said("scanSetupNotice"), "The site has no tile T-0009.");
  QTest::keyClick(find("scanTile"), Qt::Key_Backspace);
  QTest::keyClicks(find("scanTile"), "2");
  startWithPort();
  EXPECT_EQ(said("scanTitle"), "Tile T-0002");
  for (int n = 0; n < 8; ++n) bench.say(QStringLiteral("04A1B2C%1\n").arg(n).toLatin1().constData());
  EXPECT_EQ(said("scanTitle"), "All done");
  EXPECT_TRUE(document.site().tiles[0].uids.empty());
  EXPECT_EQ(uids(1).size(), 8U);
  click("scanEnd");
  const floor::Site before = document.site();
  click("clearTileTags");
  EXPECT_TRUE(document.site().tiles[1].uids.empty());
  document.undoStack().undo();
  EXPECT_EQ(document.site(), before);
}

TEST_F(Counter, asksAModuleAgainAndAgain) {
  find<QComboBox>("scanForm")->setCurrentIndex(3);
  startWithPort();
  EXPECT_TRUE(QTest::qWaitFor([&] { return bench.sent.size() >= 4; }));
  Q_EMIT bench.received(QByteArray::fromHex("AABB0A0052510202004CD9008016"));
  EXPECT_EQ(uids(0), std::vector<std::string>{"4CD90080"});
}

TEST_F(Counter, saysThatThereIsNothingToRegisterOnAFloorWithoutTiles) {
  document.replace(floor::SiteMap::build({}).value(), {});
  EXPECT_FALSE(find<QPushButton>("startScan")->isEnabled());
  EXPECT_EQ(said("scanSetupNotice"), "The site has no tiles yet. Lay them first.");
}

TEST_F(Counter, endsWhenAnotherSiteIsOpened) {
  startWithPort();
  document.replace(floor::SiteMap::build({}).value(), {});
  EXPECT_EQ(registrar.state(), Registrar::State::Idle);
  EXPECT_GE(bench.closes, 1);
  bench.say("04A1B2C3\r\n");
}

TEST_F(Counter, goesOnAtATagThatIsDoubleClickedAndMarksOneThatIsAskedFor) {
  FloorCanvas canvas;
  canvas.resize(900, 600);
  canvas.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&canvas));
  canvas.openMap(document.map());
  RegisterTool tool{registrar, panel.page()};
  canvas.setTool(&tool);
  startWithPort();
  const auto& walk = registrar.registration()->walk();
  const QPoint there = canvas.view().toPixel(*walk[11].place).toPoint();
  QTest::mouseDClick(&canvas, Qt::LeftButton, {}, there);
  EXPECT_EQ(registrar.place(), scan::nameOf(document.site(), walk[11]));
  bench.say("04A1B2C3\r\n");
  EXPECT_EQ(tool.mark(scan::nameOf(document.site(), walk[11])), walk[11].place);
  EXPECT_FALSE(tool.mark({"T-0001", 0}));
  QTest::keyClick(&canvas, Qt::Key_Backspace);
  EXPECT_EQ(registered(), 0U);
  QTest::keyClick(&canvas, Qt::Key_Escape);
  EXPECT_EQ(canvas.tool(), nullptr);
}

}  // namespace
}  // namespace tessera::ui
