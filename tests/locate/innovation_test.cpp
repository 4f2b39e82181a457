// How far tags lie from where they are expected, by hand and over whole drives.
#include "locate/innovation.h"

#include <gtest/gtest.h>

#include "locate/paper_floor.h"
#include "locate/synthetic_drive.h"

namespace tessera::test {
namespace {

using locate::Innovation;
using locate::innovationOf;
using locate::Locator;

locate::Estimate standingAtOrigin() {
  locate::Estimate e;
  e.located = true;
  return e;
}

TEST(Innovation, isWithinTheDiscOfAReaderThatStands) {
  const Offset mount{Metres{0.15}, Metres{}};
  const auto at = [&](double x, double y) {
    return innovationOf(standingAtOrigin(), mount, Metres{0.06}, {Metres{x}, Metres{y}});
  };
  EXPECT_NEAR(at(0.15, 0.0).nis, 0.0, 1e-9);
  EXPECT_NEAR(at(0.21, 0.0).nis, 4.0, 1e-9) << "an even disc has a quarter of its radius squared as variance";
  EXPECT_NEAR(at(0.15, 0.03).nis, 1.0, 1e-9);
  EXPECT_NEAR(at(0.15, 0.03).aside.value(), 0.03, 1e-12);
}

TEST(Innovation, expectsATagAtTheFrontRimOfAReaderThatMoves) {
  locate::Estimate e = standingAtOrigin();
  e.pose = {{Metres{2.0}, Metres{1.0}}, Radians{kPi / 2}};
  e.speed = MetresPerSecond{0.12};
  const Offset mount{Metres{0.1}, Metres{0.05}};
  const double ahead = kPi / 4 * 0.06 - 0.006;
  const Innovation none = innovationOf(e, mount, Metres{0.06}, {Metres{1.95}, Metres{1.1 + ahead}});
  EXPECT_NEAR(none.nis, 0.0, 1e-9);
  const Innovation behind = innovationOf(e, mount, Metres{0.06}, {Metres{1.95}, Metres{1.1 - ahead}});
  EXPECT_NEAR(behind.ahead.value(), -2 * ahead, 1e-9);
  EXPECT_GT(behind.nis, 20.0) << "it should have been read long before";
  e.speed = MetresPerSecond{-0.12};
  EXPECT_NEAR(innovationOf(e, mount, Metres{0.06}, {Metres{1.95}, Metres{1.1 - ahead}}).nis, 0.0, 1e-9)
      << "backwards, the rim at the back comes first";
  e.speed = {};
  e.turnRate = RadiansPerSecond{1.2};
  for (const double side : {-0.06, 0.06})
    EXPECT_NEAR(innovationOf(e, {Metres{0.1}, Metres{}}, Metres{0.06}, {Metres{2.0 + side}, Metres{1.1}}).nis, 2.0,
                1e-9)
        << "on the spot, the rim on any side";
}

TEST(Innovation, weighsLessWhereMoreIsInDoubt) {
  locate::Estimate e = standingAtOrigin();
  const Offset mount{Metres{0.2}, Metres{}};
  const Point tag{Metres{0.2}, Metres{0.05}};
  const double sure = innovationOf(e, mount, Metres{0.06}, tag).nis;
  e.covariance(2, 2) = 0.2 * 0.2;  // of the heading, at a lever of 20 cm: 4 cm aside
  EXPECT_NEAR(innovationOf(e, mount, Metres{0.06}, tag).nis, 0.05 * 0.05 / (0.03 * 0.03 + 0.04 * 0.04), 1e-9);
  EXPECT_LT(innovationOf(e, mount, Metres{0.06}, tag).nis, sure);
}

TEST(Innovation, hasTheBoundsOfAChiSquaredMean) {
  // Of 50 degrees of freedom: 32.357 and 71.420.
  EXPECT_NEAR(locate::meanBounds(25).low, 32.357 / 25, 0.01);
  EXPECT_NEAR(locate::meanBounds(25).high, 71.420 / 25, 0.01);
  EXPECT_NEAR(locate::meanBounds(1).high, 7.378, 0.08);
}

/// Notes what each read would have said before it is passed on.
class Noting final : public Locator {
public:
  Noting(std::unique_ptr<Locator> inner, std::shared_ptr<const floor::SiteMap> map)
      : inner_{std::move(inner)}, map_{std::move(map)} {}
  void add(const locate::Motion& motion) override { inner_->add(motion); }
  void add(const locate::TagRead& read) override {
    const auto before = inner_->at(read.at);
    const auto place = map_->find(read.uid);
    if (before.located && place) {
      const floor::VehicleSetup setup = paperVehicle();
      nis += innovationOf(before, setup.readers[static_cast<std::size_t>(read.reader)], setup.readerRadius, *place).nis;
      ++count;
    }
    inner_->add(read);
  }
  void add(const locate::TagLeft& left) override { inner_->add(left); }
  void told(Seconds from, Seconds until) override { inner_->told(from, until); }
  [[nodiscard]] locate::Estimate at(Seconds now) const override { return inner_->at(now); }
  [[nodiscard]] Seconds lastMotion() const override { return inner_->lastMotion(); }
  void reset(std::optional<Pose> pose) override { inner_->reset(pose); }
  void useMap(std::shared_ptr<const floor::SiteMap> map) override { inner_->useMap(std::move(map)); }
  [[nodiscard]] const locate::LocatorCounters& counters() const override { return inner_->counters(); }
  [[nodiscard]] std::string_view name() const override { return inner_->name(); }

  double nis = 0.0;
  int count = 0;

private:
  std::unique_ptr<Locator> inner_;
  std::shared_ptr<const floor::SiteMap> map_;
};

TEST(Innovation, isAboutTwoOnAverageForLocatorsThatAreHonest) {
  const auto map = paperMap();
  for (const char* name : {"particles", "kalman"}) {
    double nis = 0.0;
    int count = 0;
    for (std::uint32_t seed = 1; seed <= 8; ++seed) {
      Noting locator{locate::makeLocator(name, map, paperVehicle()).value(), map};
      DriveOptions options;
      options.seed = seed;
      (void)drive(*map, paperVehicle(), map->route("paper")->vertices, options, locator);
      nis += locator.nis;
      count += locator.count;
    }
    RecordProperty(std::string{name} + "_nis", std::to_string(nis / count));
    std::printf("%s: mean NIS %.3f of %d reads\n", name, nis / count, count);
    EXPECT_GT(count, 300);
    EXPECT_GT(nis / count, 1.0) << name;
    EXPECT_LT(nis / count, 2.7) << name;
  }
}

}  // namespace
}  // namespace tessera::test
