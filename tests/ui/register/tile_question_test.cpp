// A tile is read in another order than it is registered in, and what is heard meanwhile.
#include <QCheckBox>

#include "counter.h"

namespace tessera::ui {
namespace {

class TileQuestion : public Counter {
protected:
  void SetUp() override {
    Counter::SetUp();
    memory.reader_.sounds = true;
    find<QCheckBox>("scanSounds")->setChecked(true);
    registrar.setSounder(
        [this](Registrar::Sound sound) { heard << (sound == Registrar::Sound::Registered ? "+" : "-"); });
  }
  [[nodiscard]] bool offers(const char* button) { return find<QPushButton>(button)->isVisible(); }
  void registerThree() {
    startWithPort();
    bench.say("04000001\n04000002\n04000003\n");
    ASSERT_EQ(registered(), 3U);
    place = registrar.place();
    before = document.site();
  }

  QStringList heard;
  std::optional<scan::PlaceName> place;
  floor::Site before;
};

TEST_F(TileQuestion, isAskedAndExchangesTwoTags) {
  ASSERT_NO_FATAL_FAILURE(registerThree());
  QTest::keyClick(find("scanPage"), Qt::Key_PageUp);
  place = registrar.place();
  bench.say("04000001\n");
  EXPECT_EQ(document.site(), before) << "nothing happens before the answer";
  EXPECT_EQ(said("scanNotice"),
            "Tag 04000001 is registered already, as tag 1 of this tile. Exchange it with the one that is registered "
            "here, or read the whole tile anew?");
  EXPECT_EQ(find<QPushButton>("scanExchange")->text(), "Exchange the two");
  EXPECT_TRUE(offers("scanWhere") && offers("scanAnew"));
  click("scanExchange");
  EXPECT_EQ(uids(0)[0], "04000003");
  EXPECT_EQ(uids(0)[place->tag], "04000001");
  EXPECT_EQ(document.undoStack().undoText(),
            QStringLiteral("Exchange tags 1 and %1 of tile T-0001").arg(place->tag + 1));
  EXPECT_FALSE(offers("scanWhere") || offers("scanExchange") || offers("scanAnew"));
  EXPECT_NE(registrar.place(), place);
  click("scanBack");
  EXPECT_EQ(document.site(), before);
  EXPECT_EQ(registrar.place(), place);
}

TEST_F(TileQuestion, movesATagToAnOpenPlace) {
  ASSERT_NO_FATAL_FAILURE(registerThree());
  bench.say("04000001\n");
  EXPECT_EQ(find<QPushButton>("scanExchange")->text(), "Move it here");
  click("scanExchange");
  EXPECT_EQ(uids(0)[0], "");
  EXPECT_EQ(uids(0)[place->tag], "04000001");
  document.undoStack().undo();
  EXPECT_EQ(document.site(), before);
  EXPECT_EQ(registrar.place(), place);
}

TEST_F(TileQuestion, readsTheWholeTileAnew) {
  ASSERT_NO_FATAL_FAILURE(registerThree());
  bench.say("04000002\n");
  click("scanAnew");
  EXPECT_TRUE(document.site().tiles[0].uids.empty());
  EXPECT_EQ(registrar.place(), (scan::PlaceName{"T-0001", 0}));
  EXPECT_TRUE(said("scanNotice").startsWith("The tile's tags are read anew")) << said("scanNotice").toStdString();
  bench.say("04000003\n04000002\n04000001\n");
  EXPECT_EQ(uids(0)[0], "04000003");
  EXPECT_EQ(registered(), 3U);
  Registrar after{document, bench, memory};
  after.start(*memory.course_, memory.reader_);
  EXPECT_EQ(after.place(), registrar.place()) << "as after a kill: it goes on in the new order";
  after.end();
  for (int n = 0; n < 4; ++n) click("scanBack");
  EXPECT_EQ(document.site(), before);
  EXPECT_EQ(registrar.place(), place);
}

TEST_F(TileQuestion, takesTheTagInTheHandWhereItIsTheFirstOfTheTile) {
  ASSERT_NO_FATAL_FAILURE(registerThree());
  while (registrar.place() != scan::PlaceName{"T-0001", 0}) QTest::keyClick(find("scanPage"), Qt::Key_PageUp);
  bench.say("04000002\n");
  click("scanAnew");
  EXPECT_EQ(uids(0), std::vector<std::string>{"04000002"});
  EXPECT_EQ(said("scanNotice"), "Registered: 04000002");
}

TEST_F(TileQuestion, isGivenUpByAnyOtherStep) {
  ASSERT_NO_FATAL_FAILURE(registerThree());
  for (const Qt::Key key : {Qt::Key_PageUp, Qt::Key_Delete, Qt::Key_Backspace}) {
    bench.say("04000002\n04000001\n");
    ASSERT_TRUE(offers("scanAnew")) << key;
    QTest::keyClick(find("scanPage"), key);
    EXPECT_FALSE(offers("scanAnew")) << key;
    EXPECT_FALSE(registrar.question()) << key;
  }
  bench.say("04000002\n04000001\n");
  ASSERT_TRUE(registrar.question());
  bench.say("04000009\n");
  EXPECT_FALSE(offers("scanAnew"));
  EXPECT_EQ(said("scanNotice"), "Registered: 04000009");
}

TEST_F(TileQuestion, soundsOnceForEachReadUnlessItIsMuted) {
  ASSERT_NO_FATAL_FAILURE(registerThree());
  EXPECT_EQ(heard, (QStringList{"+", "+", "+"}));
  bench.say("04000003\n");
  EXPECT_EQ(heard.size(), 3) << "the card that lies there still";
  bench.say("04000001\nrubbish\n");
  EXPECT_EQ(heard, (QStringList{"+", "+", "+", "-", "-"}));
  click("scanSound");
  bench.say("04000004\n04000001\n");
  EXPECT_EQ(registered(), 4U);
  EXPECT_EQ(heard.size(), 5);
  EXPECT_FALSE(memory.reader_.sounds) << "and the next time as well";
  click("scanEnd");
  EXPECT_FALSE(find<QCheckBox>("scanSounds")->isChecked());
}

}  // namespace
}  // namespace tessera::ui
