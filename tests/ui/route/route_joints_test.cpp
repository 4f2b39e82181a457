// Two routes made one, one made two, by call, by panel and by menu; and what a route would be while it is drawn.
#include <QAction>
#include <QLabel>
#include <QListWidget>
#include <QTableView>

#include "drawing_board.h"
#include "ui/route/route_panel.h"

namespace tessera::ui {
namespace {

Point spot(double x, double y) { return {Metres{x}, Metres{y}}; }

class RouteJoints : public testing::Test {
protected:
  RouteJoints() {
    floor::Site site = tiledSite(5, 4);
    site.routes = {
        {"a", {spot(0, 0), spot(1, 0), spot(1, 1)}, Metres{0.2}},  {"behind", {spot(1, 1), spot(2, 1)}, Metres{0.3}},
        {"behind, turned", {spot(2, 2), spot(1, 1)}, Metres{0.2}}, {"before", {spot(0, 2), spot(0, 0)}, Metres{0.2}},
        {"before, turned", {spot(0, 0), spot(0, 3)}, Metres{0.2}}, {"far", {spot(2, 0), spot(3, 0)}, Metres{0.2}}};
    document.replace(floor::SiteMap::build(site).value(), {});
    before = document.site();
  }
  SiteDocument document;
  RouteEdits edits{document};
  floor::Site before;
};

TEST_F(RouteJoints, AreFoundWhereEndsTouch) {
  EXPECT_EQ(edits.touching("a"), (QStringList{"behind", "behind, turned", "before", "before, turned"}));
  EXPECT_TRUE(edits.touching("far").isEmpty());
  EXPECT_TRUE(edits.touching("nowhere").isEmpty());
}

TEST_F(RouteJoints, MakeOneRouteTurningTheOtherWhereItHasTo) {
  const std::vector own{spot(0, 0), spot(1, 0), spot(1, 1)};
  const auto joined = [&](const QString& other) {
    EXPECT_TRUE(edits.join("a", other)) << other.toStdString();
    EXPECT_EQ(edits.find(other), nullptr);
    EXPECT_EQ(document.site().routes.size(), before.routes.size() - 1);
    std::vector<Point> vertices = edits.find("a")->vertices;
    document.undoStack().undo();
    EXPECT_EQ(document.site(), before);
    return vertices;
  };
  EXPECT_EQ(joined("behind"), (std::vector{own[0], own[1], own[2], spot(2, 1)}));
  EXPECT_EQ(joined("behind, turned"), (std::vector{own[0], own[1], own[2], spot(2, 2)}));
  EXPECT_EQ(joined("before"), (std::vector{spot(0, 2), own[0], own[1], own[2]}));
  EXPECT_EQ(joined("before, turned"), (std::vector{spot(0, 3), own[0], own[1], own[2]}));
  EXPECT_FALSE(edits.join("a", "far"));
  EXPECT_FALSE(edits.join("a", "a"));
  EXPECT_FALSE(edits.join("a", "nowhere"));
}

TEST_F(RouteJoints, AreUndoneBySplittingThere) {
  const QString rest = edits.split("a", 1).value();
  EXPECT_EQ(rest, "a (part 2)");
  EXPECT_EQ(edits.find("a")->vertices, (std::vector{spot(0, 0), spot(1, 0)}));
  EXPECT_EQ(edits.find(rest)->vertices, (std::vector{spot(1, 0), spot(1, 1)}));
  ASSERT_TRUE(edits.join("a", rest));
  EXPECT_EQ(document.site(), before);
  EXPECT_FALSE(edits.split("a", 0));
  EXPECT_FALSE(edits.split("a", 2));
  EXPECT_FALSE(edits.split("nowhere", 1));
}

TEST_F(RouteJoints, KeepTheSpeedsOfTheirLegs) {
  const MetresPerSecond slow{0.1};
  const MetresPerSecond fast{0.4};
  ASSERT_TRUE(edits.setLegSpeed("a", 0, slow));
  ASSERT_TRUE(edits.setLegSpeed("before, turned", 0, fast));
  const floor::Site marked = document.site();
  ASSERT_TRUE(edits.join("a", "before, turned"));
  EXPECT_EQ(edits.find("a")->legSpeeds, (std::vector<std::optional<MetresPerSecond>>{fast, slow, std::nullopt}));
  const QString rest = edits.split("a", 1).value();
  EXPECT_EQ(edits.find("a")->legSpeeds, (std::vector{std::optional{fast}}));
  EXPECT_EQ(edits.find(rest)->legSpeeds, (std::vector<std::optional<MetresPerSecond>>{slow, std::nullopt}));
  for (int n = 0; n < 2; ++n) document.undoStack().undo();
  EXPECT_EQ(document.site(), marked);
  ASSERT_TRUE(edits.reverse("a"));
  EXPECT_EQ(edits.find("a")->legSpeeds, (std::vector<std::optional<MetresPerSecond>>{std::nullopt, slow}));
}

TEST_F(RouteJoints, AreMadeAndSplitInThePanel) {
  Selection selection;
  RoutePanel panel{document, selection};
  panel.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
  const auto action = [&](const char* name) { return panel.findChild<QAction*>(name); };
  selection.setRoute("far");
  EXPECT_FALSE(action("joinRouteAction")->isEnabled());
  selection.setRoute("a");
  const auto others = action("joinRouteAction")->menu()->actions();
  ASSERT_EQ(others.size(), 4);
  others[2]->trigger();
  EXPECT_EQ(edits.find("a")->vertices.size(), 4U);
  auto* table = panel.findChild<QTableView*>("vertexTable");
  table->setCurrentIndex(table->model()->index(0, 0));
  EXPECT_FALSE(action("splitRouteAction")->isEnabled());
  table->setCurrentIndex(table->model()->index(1, 0));
  action("splitRouteAction")->trigger();
  EXPECT_EQ(edits.find("a")->vertices.size(), 2U);
  while (document.undoStack().canUndo()) document.undoStack().undo();
  EXPECT_EQ(document.site(), before);
}

TEST_F(RouteJoints, TakeTheTimeThatTheChosenVehicleNeeds) {
  QLocale::setDefault(QLocale::c());
  Selection selection;
  RoutePanel panel{document, selection};
  auto* label = panel.findChild<QLabel*>("routeLength");
  selection.setRoute("a");
  EXPECT_EQ(label->text(), "2.00 m, about 10 s");
  selection.setVehicle(VehicleId{1});
  const QString driven = label->text();
  EXPECT_NE(driven, "2.00 m, about 10 s") << "it brakes, turns by a right angle and starts again";
  ASSERT_TRUE(document.edit("Slow", [](floor::Site& site) { site.vehicles[0].maxSpeed = MetresPerSecond{0.05}; }));
  EXPECT_NE(label->text(), driven) << "it cannot go as fast as that";
}

class RouteTrial : public DrawingBoard {};

TEST_F(RouteTrial, IsTheRouteAsItWouldBeWhileDrawnAndDragged) {
  EXPECT_FALSE(tool.trial());
  tool.startDrawing();
  click(0.6, 0.6);
  QTest::mouseMove(&canvas, pixel(1.2, 0.6));
  ASSERT_TRUE(tool.trial());
  EXPECT_EQ(tool.trial()->vertices, (std::vector{at(0.6, 0.6), at(1.2, 0.6)}));
  key(Qt::Key_Escape);
  EXPECT_FALSE(tool.trial());
  key(Qt::Key_Escape);
  canvas.setTool(&tool);
  selection.setRoute("one");
  QTest::mousePress(&canvas, Qt::LeftButton, {}, pixel(2.0, 0.5));
  moveTo(pixel(2.4, 0.6), {});
  ASSERT_TRUE(tool.trial());
  EXPECT_EQ(tool.trial()->name, "one");
  expectAt(tool.trial()->vertices[1], 2.4, 0.6, 0.02);
  QTest::mouseRelease(&canvas, Qt::LeftButton, {}, pixel(2.4, 0.6));
  EXPECT_FALSE(tool.trial());
}

TEST_F(RouteTrial, KeepsTheSpeedOfALegThatIsDraggedInTwo) {
  selection.setRoute("one");
  ASSERT_TRUE(RouteEdits{document}.setLegSpeed("one", 0, MetresPerSecond{0.1}));
  const auto both =
      std::vector<std::optional<MetresPerSecond>>{MetresPerSecond{0.1}, MetresPerSecond{0.1}, std::nullopt};
  QTest::mousePress(&canvas, Qt::LeftButton, {}, pixel(1.25, 0.5));
  moveTo(pixel(1.25, 0.9), {});
  ASSERT_TRUE(tool.trial());
  EXPECT_EQ(tool.trial()->legSpeeds, both);
  QTest::mouseRelease(&canvas, Qt::LeftButton, {}, pixel(1.25, 0.9));
  EXPECT_EQ(document.map()->route("one")->legSpeeds, both);
}

TEST_F(RouteTrial, ShowsWhatIsWrongWithItBesideTheCursor) {
  tool.startDrawing();
  click(0.6, 0.6);
  QTest::mouseMove(&canvas, pixel(1.2, 0.6));
  canvas.finishDrawing();
  const QImage fine = canvas.grab().toImage();
  QSignalSpy changed{&tool, &CanvasTool::changed};
  tool.setTrialFaults({{{at(1.0, 0.6), at(1.2, 0.6)}, true, "leads somewhere it must not"}});
  EXPECT_EQ(changed.count(), 1);
  canvas.finishDrawing();
  EXPECT_NE(canvas.grab().toImage(), fine);
  tool.setTrialFaults({});
  canvas.finishDrawing();
  EXPECT_EQ(canvas.grab().toImage(), fine);
}

}  // namespace
}  // namespace tessera::ui
