// Magnetic maps are kept for each site file and world, and what cannot be read is told.
#include "store/magnetic_maps.h"

#include <gtest/gtest.h>

#include "locate/magnetic_file.h"
#include "store/store_fixture.h"
#include "store/store_thread.h"

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

TEST_F(MagneticMapsOfSites, haveAPlaceInADatabaseOfTheVersionBefore) {
  ASSERT_NO_FATAL_FAILURE(backTo(5));
  const auto database = open();
  EXPECT_TRUE(MagneticMaps{*database}.save("/a", false, mapWith(0.1), 1));
}

}  // namespace
}  // namespace tessera::store
