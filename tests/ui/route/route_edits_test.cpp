#include "ui/route/route_edits.h"

#include <gtest/gtest.h>

#include <random>

#include "canvas_site.h"
#include "floor/site_json.h"

namespace tessera::ui {
namespace {

Point place(double x, double y) { return {Metres{x}, Metres{y}}; }

class RouteEditing : public testing::Test {
protected:
  void SetUp() override { document.replace(tiledMap(2, 2), {}); }
  SiteDocument document;
  RouteEdits edits{document};
};

TEST_F(RouteEditing, NamesNewRoutesByTheFirstFreeNumber) {
  EXPECT_EQ(edits.add({place(0, 0), place(1, 0)}).value(), "Route 1");
  EXPECT_EQ(edits.add({place(0, 0), place(1, 0)}).value(), "Route 2");
  ASSERT_TRUE(edits.remove("Route 1"));
  EXPECT_EQ(edits.freeName(), "Route 1");
  EXPECT_FALSE(edits.add({place(0, 0)}));
}

TEST_F(RouteEditing, RefusesNamesThatAreTakenEmptyOrTooLong) {
  EXPECT_FALSE(edits.rename("one", "two"));
  EXPECT_FALSE(edits.rename("one", "   "));
  EXPECT_FALSE(edits.rename("one", QString(300, 'x')));
  EXPECT_TRUE(edits.rename("one", "one"));
  EXPECT_EQ(document.undoStack().count(), 0);
  EXPECT_TRUE(edits.rename("one", "  至充电站 %1 "));
  EXPECT_NE(edits.find("至充电站 %1"), nullptr);
}

TEST_F(RouteEditing, DuplicatesUnderNamesOfTheirOwn) {
  const QString first = edits.duplicate("one").value();
  const QString second = edits.duplicate("one").value();
  EXPECT_NE(first, second);
  EXPECT_EQ(edits.find(first)->vertices, edits.find("one")->vertices);
  ASSERT_TRUE(edits.rename("two", QString(200, 'y')));
  EXPECT_LE(edits.duplicate(QString(200, 'y')).value().toUtf8().size(), RouteEdits::kLongestName);
  EXPECT_FALSE(edits.duplicate("nowhere"));
}

TEST_F(RouteEditing, SaysThatARouteIsGone) {
  EXPECT_FALSE(edits.reverse("nowhere"));
  EXPECT_FALSE(edits.moveVertex("nowhere", 0, place(0, 0)));
  EXPECT_FALSE(edits.setSpacing("nowhere", Metres{1}));
  EXPECT_TRUE(edits.moveVertex("one", 99, place(0, 0)));  // no such vertex: nothing to do
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(RouteEditing, KeepsWithinWhatASiteFileHolds) {
  ASSERT_TRUE(edits.setSpacing("one", Metres{1e9}));
  EXPECT_EQ(edits.find("one")->controlSpacing, RouteEdits::kMostSpacing);
  EXPECT_EQ(tidy(place(1e12, -1e12)), place(1e5, -1e5));
  EXPECT_EQ(tidy(place(0.12345, -0.00001)), place(0.123, 0.0));
}

TEST_F(RouteEditing, LeadsBackAndForthThroughAnySequenceOfEdits) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random{seed};
    document.replace(tiledMap(2, 2), {});
    const floor::Site before = document.site();
    const auto number = [&](double most) { return std::uniform_real_distribution<double>{0, most}(random); };
    for (int n = 0; n < 60; ++n) {
      const auto& all = document.site().routes;
      const QString route = all.empty() ? QString{"none"} : QString::fromStdString(all[random() % all.size()].name);
      const std::size_t vertex = random() % 4;
      const Point p = tidy(place(number(5), number(5)));
      const int mergeKey = static_cast<int>(random() % 3);
      switch (random() % 12) {
        case 0:
          static_cast<void>(edits.add({p, tidy(place(number(5), number(5)))}));
          break;
        case 1:
          static_cast<void>(edits.duplicate(route));
          break;
        case 2:
          static_cast<void>(edits.remove(route));
          break;
        case 3:
          static_cast<void>(edits.rename(route, QString("r%1").arg(random() % 6)));
          break;
        case 4:
          static_cast<void>(edits.reverse(route));
          break;
        case 5:
          static_cast<void>(edits.setSpacing(route, Metres{number(2)}, mergeKey));
          break;
        case 6:
          static_cast<void>(edits.insertVertex(route, vertex, p));
          break;
        case 7:
          static_cast<void>(edits.removeVertex(route, vertex));
          break;
        case 8:
        case 9:
          static_cast<void>(edits.setLegSpeed(route, vertex, MetresPerSecond{number(1)}));
          break;
        case 10:
          static_cast<void>(edits.split(route, vertex));
          break;
        default:
          static_cast<void>(edits.moveVertex(route, vertex, p, mergeKey));
          break;
      }
    }
    const floor::Site after = document.site();
    while (document.undoStack().canUndo()) document.undoStack().undo();
    EXPECT_EQ(document.site(), before) << "seed " << seed;
    while (document.undoStack().canRedo()) document.undoStack().redo();
    EXPECT_EQ(document.site(), after) << "seed " << seed;
    const auto written = floor::parseSite(floor::writeSite(after), "edited");
    ASSERT_TRUE(written) << "seed " << seed << ": " << written.error().sentence;
    EXPECT_EQ(*written, after) << "seed " << seed;
  }
}

}  // namespace
}  // namespace tessera::ui
