// The calibration by mouse, with a fleet of values that drives the figure with readers that sit elsewhere than entered.
#include "ui/calibrate/calibrate_panel.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

#include "locate/paper_floor.h"
#include "locate/synthetic_drive.h"
#include "tests/ui/connect/look.h"
#include "tests/ui/fleet/fake_fleet.h"

namespace tessera::ui {
namespace {

floor::VehicleSetup trueReaders() {
  floor::VehicleSetup vehicle = test::paperVehicle(2);
  vehicle.readers = {{Metres{0.172}, Metres{0.065}}, {Metres{0.143}, Metres{-0.068}}};
  return vehicle;
}

/// In a locator's place: shows each motion as a picture of the fleet, with the reads so far.
class Feeder final : public locate::Locator {
public:
  Feeder(FakeFleet& fleet, const floor::SiteMap& map) : fleet_{fleet}, map_{map} {}
  void add(const locate::Motion& motion) override {
    auto snapshot = fakeSnapshot(1, motion.at.value());
    snapshot.vehicles[0].recentReads = reads_;
    auto view = std::make_shared<supervisor::LocatingView>();
    view->vehicle = VehicleId{1};
    view->motion = motion;
    view->motion.travel = motion.travel / 1.03;  // its wheels are larger than entered
    snapshot.watched = std::move(view);
    fleet_.show(snapshot);
  }
  void add(const locate::TagRead& read) override {
    if (reads_.size() == supervisor::kRecentReads) reads_.erase(reads_.begin());
    // The real reader's result waits for its bus.
    reads_.push_back(
        {read.uid, static_cast<std::uint8_t>(read.reader), read.at + locate::kReadLag, map_.find(read.uid)});
  }
  void add(const locate::TagLeft&) override {}
  [[nodiscard]] locate::Estimate at(Seconds) const override { return {}; }
  [[nodiscard]] Seconds lastMotion() const override { return {}; }
  void reset(std::optional<Pose>) override {}
  void useMap(std::shared_ptr<const floor::SiteMap>) override {}
  [[nodiscard]] const locate::LocatorCounters& counters() const override { return counters_; }
  [[nodiscard]] std::string_view name() const override { return "feeder"; }

private:
  FakeFleet& fleet_;
  const floor::SiteMap& map_;
  std::vector<supervisor::ReadView> reads_;
  locate::LocatorCounters counters_;
};

class Calibrating : public testing::Test {
protected:
  void SetUp() override {
    floor::Site site = test::paperSite();
    site.vehicles = {test::paperVehicle(2)};
    document.replace(floor::SiteMap::build(std::move(site)).value(), {});
    panel.resize(900, 240);
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
  }
  template <class T>
  T* find(const char* name) {
    return panel.findChild<T*>(QString::fromLatin1(name));
  }
  void click(const char* name) { QTest::mouseClick(find<QAbstractButton>(name), Qt::LeftButton); }
  [[nodiscard]] QString hint() { return find<QLabel>("calibrateHint")->text(); }
  [[nodiscard]] bool soon(const QString& start) {
    return QTest::qWaitFor([&] { return hint().startsWith(start); });
  }
  void drive(const std::string& route) { drive(document.map()->route(route)->vertices); }
  void drive(const std::vector<Point>& way) {
    test::DriveOptions options;
    options.speedNoise = 0.03;
    Feeder feeder{fleet, *document.map()};
    (void)test::drive(*document.map(), trueReaders(), way, options, feeder);
  }

  FakeFleet fleet;
  Selection selection;
  SiteDocument document;
  Calibration work{fleet, document};
  CalibratePanel panel{work, fleet, selection, document};
};

TEST_F(Calibrating, saysWhatToDoAtEachPoint) {
  EXPECT_TRUE(hint().startsWith("Connect to the vehicles"));
  fleet.show(fakeSnapshot(1));
  EXPECT_TRUE(soon("Choose the vehicle"));
  EXPECT_FALSE(find<QPushButton>("recordCalibration")->isEnabled());
  selection.setVehicle(VehicleId{1});
  EXPECT_TRUE(soon("Draw the figure"));
  click("recordCalibration");
  EXPECT_TRUE(hint().startsWith("Run the vehicle"));
  ASSERT_EQ(fleet.all<supervisor::Watch>().size(), 1U);
  EXPECT_EQ(fleet.all<supervisor::Watch>()[0].who, VehicleId{1});
  click("recordCalibration");
  EXPECT_EQ(fleet.all<supervisor::Watch>().back().who, std::nullopt);
  EXPECT_FALSE(find<QPushButton>("acceptCalibration")->isEnabled());
}

TEST_F(Calibrating, findsWhereTheReadersSitAndEntersThemAsOneStep) {
  const floor::Site before = document.site();
  fleet.show(fakeSnapshot(1));
  selection.setVehicle(VehicleId{1});
  click("drawFigure");
  ASSERT_EQ(selection.route(), "Calibration");
  ASSERT_EQ(document.map()->route("Calibration")->vertices.size(), 15U);
  const floor::Site drawn = document.site();
  click("recordCalibration");
  drive("Calibration");
  click("recordCalibration");
  EXPECT_TRUE(hint().startsWith("Compare the values.")) << hint().toStdString();
  ASSERT_NE(work.result(), nullptr);
  auto* table = find<QTableWidget>("calibrateTable");
  ASSERT_EQ(table->rowCount(), 5);
  EXPECT_EQ(table->item(0, 0)->text(), "Reader 1, ahead (mm)");
  EXPECT_EQ(table->item(0, 1)->text(), "150.0");
  EXPECT_NEAR(table->item(0, 2)->text().toDouble(), 172.0, 12.0);
  EXPECT_NEAR(table->item(4, 2)->text().toDouble(), 103.0, 1.5) << "mm, of the wheels";
  EXPECT_EQ(document.site(), drawn) << "nothing is entered before it was looked at";
  for (const bool dark : {false, true}) {
    look::setDark(dark);
    look::take(panel, dark ? "calibrate-dark" : "calibrate-light");
  }
  look::setDark(false);
  click("acceptWheels");
  click("acceptCalibration");
  const floor::VehicleSetup& now = document.site().vehicles.front();
  for (std::size_t r = 0; r < 2; ++r)
    EXPECT_LT(length(now.readers[r] + -1.0 * trueReaders().readers[r]), Metres{0.012}) << r;
  EXPECT_NEAR(now.wheelDiameter.value(), 0.103, 0.0015);
  EXPECT_EQ(work.result(), nullptr) << "what was recorded is of the old offsets";
  EXPECT_TRUE(hint().startsWith("Draw the figure"));
  document.undoStack().undo();
  EXPECT_EQ(document.site(), drawn);
  document.undoStack().undo();
  EXPECT_EQ(document.site(), before);
}

TEST_F(Calibrating, entersNothingThatIsNotKnownWellEnoughAndSaysWhatIsMissing) {
  fleet.show(fakeSnapshot(1));
  selection.setVehicle(VehicleId{1});
  click("drawFigure");
  const floor::Site drawn = document.site();
  const auto expectNothingToEnter = [&](const QString& missing) {
    ASSERT_NE(work.result(), nullptr);
    EXPECT_TRUE(find<QLabel>("calibrateMissing")->text().startsWith(missing))
        << find<QLabel>("calibrateMissing")->text().toStdString();
    EXPECT_FALSE(find<QPushButton>("acceptCalibration")->isEnabled());
    EXPECT_FALSE(find<QCheckBox>("acceptWheels")->isEnabled());
    EXPECT_TRUE(hint().startsWith("The drive was too short, or turned too little")) << hint().toStdString();
    click("acceptCalibration");
    EXPECT_TRUE(work.accept(true));
    EXPECT_EQ(document.site(), drawn);
  };
  std::vector<Point> beginning = document.map()->route("Calibration")->vertices;
  beginning.resize(4);
  click("recordCalibration");
  drive(beginning);
  click("recordCalibration");
  expectNothingToEnter("Not known well enough yet: let it make 3 half turns at least.");
  look::take(panel, QStringLiteral("calibrate-poor"));

  // To and fro past the same tags: it turns often enough, and learns little.
  click("resetCalibration");
  EXPECT_EQ(find<QLabel>("calibrateMissing")->text(), "");
  click("recordCalibration");
  std::vector<Point> line;
  for (int leg = 0; leg < 7; ++leg) line.push_back({Metres{0.6}, Metres{leg % 2 == 0 ? 0.4 : 1.3}});
  drive(line);
  click("recordCalibration");
  expectNothingToEnter("Not known well enough yet: drive on until the offsets' deviations are below ± 8.0 mm.");

  click("resetCalibration");
  click("recordCalibration");
  drive("Calibration");
  click("recordCalibration");
  EXPECT_EQ(find<QLabel>("calibrateMissing")->text(), "");
  EXPECT_TRUE(find<QPushButton>("acceptCalibration")->isEnabled());
  EXPECT_TRUE(find<QCheckBox>("acceptWheels")->isEnabled());
}

TEST_F(Calibrating, leavesTheWheelsAloneUnlessTold) {
  fleet.show(fakeSnapshot(1));
  selection.setVehicle(VehicleId{1});
  click("drawFigure");
  click("recordCalibration");
  drive("Calibration");
  click("recordCalibration");
  click("acceptCalibration");
  EXPECT_EQ(document.site().vehicles.front().wheelDiameter, Metres{0.10});
  EXPECT_NE(document.site().vehicles.front().readers, test::paperVehicle(2).readers);
}

TEST_F(Calibrating, goesOnAfterAPauseAndBeginsAnewWhenAsked) {
  fleet.show(fakeSnapshot(1));
  selection.setVehicle(VehicleId{1});
  click("recordCalibration");
  drive("paper");
  click("recordCalibration");
  const auto reads = work.drive().reads().size();
  EXPECT_GT(reads, 20U);
  drive("paper");
  EXPECT_EQ(work.drive().reads().size(), reads) << "paused";
  click("resetCalibration");
  EXPECT_TRUE(work.drive().reads().empty());
  EXPECT_FALSE(find<QPushButton>("resetCalibration")->isEnabled());
}

TEST_F(Calibrating, refusesTheFigureWhereItHasNoRoom) {
  floor::Site site = test::paperSite();
  site.vehicles = {test::paperVehicle(2)};
  site.placements.resize(3);  // one row of tiles
  document.replace(floor::SiteMap::build(std::move(site)).value(), {});
  QSignalSpy refused{&panel, &CalibratePanel::refused};
  click("drawFigure");
  ASSERT_EQ(refused.count(), 1);
  EXPECT_EQ(refused[0][0].toString(), "The floor is too small for the figure: it needs 1.4 m by 1.4 m.");
  EXPECT_TRUE(document.map()->route("Calibration") == nullptr);
}

}  // namespace
}  // namespace tessera::ui
