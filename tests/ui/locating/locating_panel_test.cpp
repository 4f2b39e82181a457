// The locating view by mouse and keys, with a fleet of values, and its drawing upon the floor.
#include "ui/locating/locating_panel.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QSignalSpy>
#include <QTest>

#include "canvas_site.h"
#include "tests/ui/connect/look.h"
#include "tests/ui/locating/locating_values.h"
#include "ui/canvas/floor_canvas.h"

namespace tessera::ui {
namespace {

using supervisor::Watch;

class FakeTruth : public TruthSource {
public:
  [[nodiscard]] bool isThere() const override { return there; }
  void ask(VehicleId vehicle) override { asked.push_back(vehicle); }
  void tell(const TruthSample& sample) { Q_EMIT told(sample); }
  bool there = false;
  std::vector<VehicleId> asked;
};

class Locating : public testing::Test {
protected:
  void SetUp() override {
    floor::Site site = tiledSite(4, 3);
    site.vehicles = fakeSite(2, {}).vehicles;
    document.replace(floor::SiteMap::build(std::move(site)).value(), {});
    panel.resize(360, 640);
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
  }
  void watch() {
    selection.setVehicle(VehicleId{1});
    fleet.show(watchedSnapshot(10.0, 1.0));
  }
  [[nodiscard]] QString text(const char* name) const {
    const auto* label = panel.findChild<QLabel*>(QString::fromLatin1(name));
    return label != nullptr && label->isVisible() ? label->text() : QStringLiteral("(not seen)");
  }
  [[nodiscard]] bool soon(const char* name, const QString& expected) const {
    return QTest::qWaitFor([&] { return text(name) == expected; });
  }

  FakeFleet fleet;
  Selection selection;
  SiteDocument document;
  FakeTruth truth;
  LocatingPanel panel{fleet, selection, document, truth};
};

TEST_F(Locating, SaysWhatToDoNext) {
  EXPECT_EQ(text("locatingHint"), "Connect to the vehicles to see how they are located.");
  fleet.show(fakeSnapshot(2));
  EXPECT_TRUE(soon("locatingHint", "Choose a vehicle in the list or on the floor to see how it is located."));
  selection.setVehicle(VehicleId{2});
  EXPECT_TRUE(soon("locatingHint", "Nothing is heard of AGV 2 yet. Its locating shows with its first report."));
  document.replace(floor::SiteMap::build({}).value(), {});
  EXPECT_TRUE(soon("locatingHint", "The site has no vehicle yet. Set one up: Vehicle › Set up a new vehicle."));
}

TEST_F(Locating, WatchesTheChosenVehicleOnlyWhileItIsSeen) {
  fleet.show(fakeSnapshot(2));
  EXPECT_TRUE(fleet.orders.empty());
  selection.setVehicle(VehicleId{2});
  ASSERT_EQ(fleet.all<Watch>().size(), 1U);
  EXPECT_EQ(fleet.all<Watch>()[0], Watch{VehicleId{2}});
  fleet.show(fakeSnapshot(2, 10.1));
  EXPECT_EQ(fleet.all<Watch>().size(), 1U) << "the answer may take a moment";
  selection.setVehicle(VehicleId{1});
  ASSERT_EQ(fleet.all<Watch>().size(), 2U);
  fleet.show(watchedSnapshot(10.2, 1.0));
  EXPECT_EQ(fleet.all<Watch>().size(), 2U);
  panel.hide();
  EXPECT_EQ(fleet.all<Watch>().back(), Watch{});
  EXPECT_TRUE(panel.overlay().empty());
  fleet.show(watchedSnapshot(10.3, 1.0));
  EXPECT_TRUE(panel.overlay().empty()) << "nobody looks";
  panel.show();
  EXPECT_FALSE(panel.overlay().empty());
}

// A new supervision knows nothing of who is watched.
TEST_F(Locating, AsksAgainWhenTheSupervisionBeganAnew) {
  watch();
  fleet.orders.clear();
  ASSERT_TRUE(QTest::qWaitFor([&] {
    fleet.show(fakeSnapshot(1, 3.0));
    return fleet.all<Watch>().size() == 1;
  }));
  EXPECT_EQ(fleet.all<Watch>()[0], Watch{VehicleId{1}});
}

TEST_F(Locating, ShowsTheNumbersWithTheirUnits) {
  watch();
  auto snapshot = watchedSnapshot(10.5, 1.0);
  const floor::TagUid uid = document.site().tiles[0].uids[0];
  snapshot.vehicles[0].recentReads = {{uid, 0, Seconds{10.1}, Point{Metres{1.1}, Metres{0.4}}},
                                      {uid, 0, Seconds{10.3}, Point{Metres{1.2}, Metres{0.4}}}};
  fleet.show(snapshot);
  EXPECT_TRUE(soon("locatingPlace", "x 0.980 m, y 0.400 m, 0.0°"));
  EXPECT_TRUE(soon("locatingReads", "reader 1: " + QString::fromStdString(uid.text()) + ", 0.2 s ago"));
  EXPECT_EQ(text("locatingLocator"), "particles, 200 guess(es) shown");
  EXPECT_EQ(text("locatingDoubt"), "1.0 cm × 1.0 cm, 0.6°");
  EXPECT_EQ(text("locatingReport"), "0.15 s ago");
  EXPECT_EQ(text("locatingPredicted"), "x 1.050 m, y 0.400 m, 0.0°");
  EXPECT_EQ(text("locatingDelay"), "0.35 s to the next command, which holds 0.25 s");
  EXPECT_EQ(text("locatingAim"), "x 1.35 m, y 0.42 m: 30 cm ahead");
  EXPECT_EQ(text("locatingContradicted"), "1 of 12 reads; found anew: 0");
  EXPECT_EQ(text("locatingFit"), "no reads yet");
  EXPECT_EQ(text("locatingError"), "(not seen)") << "real vehicles: nobody knows the truth";
}

TEST_F(Locating, SaysThatATagSpeaksForAnotherPlace) {
  watch();
  auto snapshot = watchedSnapshot(10.5, 1.0);
  snapshot.vehicles[0].doubted = true;
  fleet.show(snapshot);
  EXPECT_TRUE(soon("locatingDoubt", "A tag speaks for another place.\n1.0 cm × 1.0 cm, 0.6°"));
  look::take(panel, QStringLiteral("locating-doubt"));
}

TEST_F(Locating, JudgesTheReadsAndCountsAnew) {
  watch();
  std::vector<locate::Innovation> many;
  for (int i = 0; i < 10; ++i) many.push_back(innovationAt(9.0 + 0.1 * i, 6.0));
  fleet.show(watchedSnapshot(11.0, 1.0, many));
  EXPECT_TRUE(soon("locatingFit",
                   "worse than expected: it is too sure of its place. NIS 6.0 on average of 10 reads, honest from 1.0 "
                   "to 3.4"))
      << text("locatingFit").toStdString();
  EXPECT_EQ(panel.findChild<InnovationChart*>()->readCount(), 10);
  QTest::mouseClick(panel.findChild<QPushButton*>("resetLocating"), Qt::LeftButton);
  EXPECT_EQ(text("locatingFit"), "no reads yet");
  EXPECT_EQ(panel.findChild<InnovationChart*>()->readCount(), 0);
}

TEST_F(Locating, AsksTheWorldForTheTruthWhereThereIsOne) {
  watch();
  truth.there = true;
  ASSERT_TRUE(QTest::qWaitFor([&] { return !truth.asked.empty(); }));
  EXPECT_EQ(truth.asked.front(), VehicleId{1});
  fleet.show(watchedSnapshot(10.1, 1.0));
  truth.tell({VehicleId{1}, Seconds{10.05}, {{Metres{1.0}, Metres{0.412}}, {}}});
  fleet.show(watchedSnapshot(10.2, 1.0));
  EXPECT_TRUE(soon("locatingError", "now 1.2 cm, mean 1.2 cm, 95 % below 1.2 cm; NEES 1.4 (2 is honest), 1 sample(s)"))
      << text("locatingError").toStdString();
  for (const supervisor::Order& order : fleet.orders)
    EXPECT_TRUE(std::holds_alternative<Watch>(order)) << "the supervision learns nothing";
}

// As it lies in the window at the size that this opens with, with the longest that there is to say.
TEST_F(Locating, ShowsTheStatisticsWithoutScrollingWhereItLiesLow) {
  panel.resize(1000, 210);
  watch();
  truth.there = true;
  std::vector<locate::Innovation> many;
  for (int i = 0; i < 25; ++i) many.push_back(innovationAt(8.0 + 0.1 * i, 12.0));
  auto snapshot = watchedSnapshot(10.1, 1.0, many);
  snapshot.vehicles[0].doubted = true;
  fleet.show(snapshot);
  for (int i = 0; i < 20; ++i) {
    truth.tell({VehicleId{1}, Seconds{10.05 + 0.1 * i}, {{Metres{1.0}, Metres{0.512}}, {}}});
    snapshot = watchedSnapshot(10.2 + 0.1 * i, 1.0);
    snapshot.vehicles[0].doubted = true;
    fleet.show(snapshot);
  }
  ASSERT_TRUE(QTest::qWaitFor([&] { return text("locatingFit").startsWith("worse than expected"); }));
  ASSERT_TRUE(QTest::qWaitFor([&] { return text("locatingError").startsWith("now 11.2 cm"); }))
      << text("locatingError").toStdString();
  for (const char* row : {"locatingPlace", "locatingDoubt", "locatingFit", "locatingError", "locatingContradicted"}) {
    const auto* label = panel.findChild<QLabel*>(QLatin1String{row});
    // A text that wraps anew is laid out a moment later.
    EXPECT_TRUE(QTest::qWaitFor([&] {
      return label->height() >= label->heightForWidth(label->width()) &&
             label->visibleRegion().boundingRect() == label->rect();
    })) << row;
  }
  look::take(panel, QStringLiteral("locating-low"));
}

TEST_F(Locating, DrawsUponTheFloorWhatIsChosen) {
  FloorCanvas canvas;
  canvas.resize(700, 500);
  canvas.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&canvas));
  canvas.openMap(document.map());
  canvas.showPlace({{Metres{0.7}, Metres{0.1}}, {Metres{1.7}, Metres{0.8}}});
  canvas.setOverlay(&panel.overlay());
  QObject::connect(&panel, &LocatingPanel::overlayChanged, &canvas, &FloorCanvas::overlayChanged);
  canvas.finishDrawing();
  const QImage bare = canvas.grab().toImage();
  watch();
  auto snapshot = watchedSnapshot(10.5, 1.0);
  snapshot.vehicles[0].recentReads = {
      {document.site().tiles[0].uids[0], 0, Seconds{10.1}, Point{Metres{1.1}, Metres{0.6}}}};
  fleet.show(snapshot);
  canvas.setSnapshot(fleet.latest());
  canvas.finishDrawing();
  const auto differs = [&](double x, double y) {
    const QPoint at = canvas.view().toPixel({Metres{x}, Metres{y}}).toPoint();
    const QImage now = canvas.grab().toImage();
    int count = 0;
    for (int dx = -9; dx <= 9; ++dx)
      for (int dy = -9; dy <= 9; ++dy)
        if (now.pixel(at + QPoint{dx, dy}) != bare.pixel(at + QPoint{dx, dy})) ++count;
    return count;
  };
  EXPECT_GT(differs(1.35, 0.42), 20) << "the point aimed at";
  EXPECT_GT(differs(1.1, 0.6), 20) << "the tag that was read";
  // With the ellipse alone there are no dots where the guesses were.
  canvas.setSnapshot(nullptr);
  const int dots = differs(0.965, 0.385);
  auto* box = panel.findChild<QComboBox*>("doubtShape");
  ASSERT_TRUE(QTest::qWaitFor([&] { return box->isEnabled(); }));
  QTest::keyClick(box, Qt::Key_Home);
  EXPECT_EQ(panel.overlay().shape(), DoubtShape::Guesses);
  QTest::keyClick(box, Qt::Key_Down);
  EXPECT_EQ(panel.overlay().shape(), DoubtShape::Ellipse);
  EXPECT_LT(differs(0.965, 0.385), dots);
  panel.hide();
  canvas.finishDrawing();
  EXPECT_EQ(canvas.grab().toImage(), bare) << "nothing stays behind";
  panel.show();
  QTest::keyClick(box, Qt::Key_End);
  canvas.zoomIn();
  canvas.zoomIn();
  std::vector<locate::Innovation> many;
  for (int i = 0; i < 40; ++i) many.push_back(innovationAt(-20.0 + i, 0.4 + (i * 7) % 5));
  snapshot = watchedSnapshot(20.0, 1.0, many);
  snapshot.vehicles[0].recentReads = {
      {document.site().tiles[0].uids[0], 0, Seconds{19.1}, Point{Metres{1.1}, Metres{0.6}}},
      {document.site().tiles[0].uids[1], 1, Seconds{19.4}, Point{Metres{1.3}, Metres{0.4}}}};
  truth.there = true;
  fleet.show(snapshot);
  canvas.setSnapshot(fleet.latest());
  ASSERT_TRUE(QTest::qWaitFor([&] { return text("locatingFit").startsWith("as expected"); }));
  for (const bool dark : {false, true}) {
    look::setDark(dark);
    canvas.finishDrawing();
    look::take(canvas, dark ? "locating-floor-dark" : "locating-floor-light");
    look::take(panel, dark ? "locating-panel-dark" : "locating-panel-light");
  }
  look::setDark(false);
  canvas.setOverlay(nullptr);
}

}  // namespace
}  // namespace tessera::ui
