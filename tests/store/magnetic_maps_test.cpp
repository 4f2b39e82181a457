// Magnetic maps are kept for each site file and world, and what cannot be read is told.
#include "store/magnetic_maps.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

#include "locate/magnetic_file.h"
#include "store/store_fixture.h"
#include "store/store_thread.h"
#include "store/transaction.h"

namespace tessera::store {
namespace {

class MagneticMapsOfSites : public test::StoreTest {
protected:
  static locate::MagneticMap mapWith(double deviation) {
    locate::MagneticMap map;
    for (std::int32_t i = 0; i < 30; ++i) map.learn({i, -i}, deviation, 1e-3);
    return map;
  }
  static double deviationIn(const std::shared_ptr<const locate::MagneticMap>& map) {
    return map ? map->at(locate::MagneticNode{3, -3}).deviation : -99.0;
  }
};

TEST_F(MagneticMapsOfSites, comeBackAndEachWorldHasItsOwn) {
  const auto database = open();
  MagneticMaps maps{*database};
  EXPECT_EQ(maps.load("/a", false).value(), nullptr);
  ASSERT_TRUE(maps.save("/a", false, mapWith(0.1), 1));
  ASSERT_TRUE(maps.save("/a", true, mapWith(-0.1), 2));
  ASSERT_TRUE(maps.save("/a", false, mapWith(0.05), 3));
  const MagneticMaps again{*database};
  EXPECT_NEAR(deviationIn(again.load("/a", false).value()), mapWith(0.05).at(locate::MagneticNode{3, -3}).deviation,
              1e-6);
  EXPECT_LT(deviationIn(again.load("/a", true).value()), 0.0);
  EXPECT_EQ(again.load("/b", false).value(), nullptr);
}

TEST_F(MagneticMapsOfSites, areGoneOnceTheyAreEmpty) {
  const auto database = open();
  MagneticMaps maps{*database};
  ASSERT_TRUE(maps.save("/a", false, mapWith(0.1), 1));
  ASSERT_TRUE(maps.save("/a", false, {}, 2));
  EXPECT_EQ(maps.load("/a", false).value(), nullptr);
}

TEST_F(MagneticMapsOfSites, thatAreDamagedAreASentence) {
  const auto database = open();
  MagneticMaps maps{*database};
  ASSERT_TRUE(maps.save("/a", false, mapWith(0.1), 1));
  Transaction writing{*database, Transaction::Kind::Write};
  writing.run(QStringLiteral("UPDATE magnetic_map SET nodes=substr(nodes, 1, 100)"));
  ASSERT_TRUE(writing.commit());
  const auto loaded = maps.load("/a", false);
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.error().sentence.english(), "The magnetic map is cut short or too long.");
  ASSERT_TRUE(maps.save("/a", false, mapWith(0.2), 3)) << "the next one takes its place";
  EXPECT_GT(deviationIn(maps.load("/a", false).value()), 0.0);
}

TEST_F(MagneticMapsOfSites, areWrittenByTheStorageThread) {
  {
    StoreThread::Options options;
    options.file = file();
    StoreThread thread{options};
    thread.start();
    for (const double deviation : {0.02, 0.05, 0.1})
      ASSERT_TRUE(thread.keepMagneticMap("/a", false, std::make_shared<locate::MagneticMap>(mapWith(deviation)), 1));
    ASSERT_TRUE(thread.close());
  }
  const auto database = open();
  EXPECT_NEAR(deviationIn(MagneticMaps{*database}.load("/a", false).value()),
              mapWith(0.1).at(locate::MagneticNode{3, -3}).deviation, 1e-6);
}

TEST_F(MagneticMapsOfSites, areReadByTheStorageThreadAfterWhatWasPostedBefore) {
  StoreThread::Options options;
  options.file = file();
  StoreThread thread{options};
  QSignalSpy loaded{&thread, &StoreThread::magneticMapLoaded};
  QSignalSpy refused{&thread, &StoreThread::requestFailed};
  thread.start();
  ASSERT_TRUE(thread.keepMagneticMap("/a", false, std::make_shared<locate::MagneticMap>(mapWith(0.1)), 1));
  const std::uint64_t request = thread.loadMagneticMap("/a", false);
  const std::uint64_t otherWorld = thread.loadMagneticMap("/a", true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return loaded.count() == 2; }));
  const auto answer = [&](int n) { return loaded[n][1].value<std::shared_ptr<const locate::MagneticMap>>(); };
  EXPECT_EQ(loaded[0][0].value<quint64>(), request);
  EXPECT_NEAR(deviationIn(answer(0)), mapWith(0.1).at(locate::MagneticNode{3, -3}).deviation, 1e-6);
  EXPECT_EQ(loaded[1][0].value<quint64>(), otherWorld);
  EXPECT_EQ(answer(1), nullptr);

  const auto database = open();
  Transaction writing{*database, Transaction::Kind::Write};
  writing.run(QStringLiteral("UPDATE magnetic_map SET nodes=substr(nodes, 1, 100)"));
  ASSERT_TRUE(writing.commit());
  const std::uint64_t damaged = thread.loadMagneticMap("/a", false);
  ASSERT_TRUE(QTest::qWaitFor([&] { return refused.count() == 1; }));
  EXPECT_EQ(refused[0][0].value<quint64>(), damaged);
}

TEST_F(MagneticMapsOfSites, haveAPlaceInADatabaseOfTheVersionBefore) {
  ASSERT_NO_FATAL_FAILURE(backTo(5));
  const auto database = open();
  EXPECT_TRUE(MagneticMaps{*database}.save("/a", false, mapWith(0.1), 1));
}

}  // namespace
}  // namespace tessera::store
