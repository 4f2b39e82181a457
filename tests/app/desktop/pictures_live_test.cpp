// Pictures of tools at work while vehicles drive, and of a site on which there is nothing yet.
#include <QBuffer>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QPainter>
#include <QTableWidget>
#include <algorithm>

#include "app/desktop/pictures.h"
#include "app/tessera/magnetic_desk.h"
#include "app/tessera/site_files.h"
#include "floor/new_floor.h"
#include "floor/site_json.h"
#include "locate/magnetic_map.h"
#include "ui/locating/locating_panel.h"

namespace tessera::desktop {
namespace {

TEST_F(Pictures, showASiteWithNothingOnItWhole) {
  const QString path = home.filePath("hall.tessera.json");
  floor::Site site;
  site.name = "hall";
  site.tileTypes.assign(floor::usualTileTypes().begin(), floor::usualTileTypes().end());
  ASSERT_TRUE(floor::saveSite(site, path.toStdString()));
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  ASSERT_TRUE(window->files().open(path));
  const auto longest = std::max_element(site.tileTypes.begin(), site.tileTypes.end(),
                                        [](const auto& a, const auto& b) { return a.name.size() < b.name.size(); });
  for (const Dress& dress : kDresses) {
    wear(dress);
    trigger("browse");
    for (const auto& [dock, view] : {std::pair{"vehiclesDock", "empty"}, {"chartsDock", "empty-charts"}}) {
      find<QDockWidget>(dock)->raise();
      take(*window, QString::fromLatin1(view), dress);
    }
    trigger("layTiles");
    find<QComboBox>("layType")->setCurrentText(QString::fromStdString(longest->name));
    take(*window, QStringLiteral("empty-lay"), dress);
    trigger("tileCheck");
    take(*window, QStringLiteral("empty-check"), dress);
  }
}

TEST_F(Pictures, showThreeVehiclesWhole) {
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  ASSERT_TRUE(window->files().open(QStringLiteral(TESSERA_SITES "/three.tessera.json")));
  window->connectTo({});
  const auto all = [&](const auto& holds) {
    const auto picture = window->session().latest();
    return picture && picture->vehicles.size() == 3 &&
           std::all_of(picture->vehicles.begin(), picture->vehicles.end(), holds);
  };
  ASSERT_TRUE(until([&] { return all([](const auto& v) { return v.located; }); }));
  const auto setups = window->document().site().vehicles;
  for (std::size_t n = 0; n < 3; ++n) {
    window->selection().setVehicle(setups[n].id);
    window->selection().setRoute(QString::fromStdString(window->document().site().routes.at(n).name));
    pressWhenOffered("runAction", Qt::Key_F5);
  }
  ASSERT_TRUE(until([&] { return all([](const auto& v) { return v.progress > Metres{0.4}; }); }));
  for (const Dress& dress : kDresses) {
    wear(dress);
    take(*window, QStringLiteral("three"), dress);
  }
}

TEST_F(Pictures, showHowADrivingVehicleIsLocatedWhole) {
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  ASSERT_NO_FATAL_FAILURE(startDemo());
  trigger("locating");
  pressWhenOffered("runAction", Qt::Key_F5);
  const auto* panel = find<ui::LocatingPanel>("locatingPanel");
  ASSERT_TRUE(until([&] { return panel->record().reads().size() >= 5 && panel->record().errors().count >= 20; }));
  for (const Dress& dress : kDresses) {
    wear(dress);
    window->canvas().centreOn(vehicle().pose.position);
    for (int n = 0; n < 3; ++n) window->canvas().zoomIn();
    take(*window, QStringLiteral("locating-live"), dress);
    window->canvas().fit();
  }
}

TEST_F(Pictures, showACalibrationWhole) {
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  ASSERT_NO_FATAL_FAILURE(startDemo());
  trigger("calibrate");
  ASSERT_TRUE(until([&] { return find("drawFigure")->isVisible() && find("recordCalibration")->isEnabled(); }));
  QTest::mouseClick(find("drawFigure"), Qt::LeftButton);
  QTest::mouseClick(find("recordCalibration"), Qt::LeftButton);
  pressWhenOffered("runAction", Qt::Key_F5);
  const auto* table = find<QTableWidget>("calibrateTable");
  ASSERT_TRUE(until([&] { return table->rowCount() > 6; }));
  for (const Dress& dress : kDresses) {
    wear(dress);
    take(*window, QStringLiteral("calibrate-live"), dress);
  }
}

TEST_F(Pictures, showASurveyOfTheCompassWhole) {
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  ASSERT_NO_FATAL_FAILURE(startDemo());
  window->selection().setVehicle(VehicleId{1});
  trigger("compass");
  ASSERT_TRUE(until([&] { return find("turnForSurvey")->isVisible() && find("turnForSurvey")->isEnabled(); }));
  QTest::mouseClick(find("turnForSurvey"), Qt::LeftButton);
  const auto* figures = find<QLabel>("surveyFigures");
  ASSERT_TRUE(until([&] { return figures->text().startsWith(QStringLiteral("Hard iron")); }))
      << find<QLabel>("surveyResult")->text().toStdString();
  for (const Dress& dress : kDresses) {
    wear(dress);
    take(*window, QStringLiteral("compass-live"), dress);
  }
}

TEST_F(Pictures, showTheIronInTheFloorWhole) {
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  ASSERT_NO_FATAL_FAILURE(startDemo());
  find<QAction>("layerIron")->setChecked(true);
  pressWhenOffered("runAction", Qt::Key_F5);
  const auto nodes = [&] { return window->magneticDesk().map()->nodeCount(); };
  // Whether it is whole shows with a few; a picture to keep is worth the longer drive.
  const std::size_t enough = qEnvironmentVariableIsSet("TESSERA_PICTURES") ? 25 : 6;
  ASSERT_TRUE(until([&] { return nodes() >= enough; })) << nodes();
  for (const Dress& dress : kDresses) {
    wear(dress);
    window->canvas().fit();
    take(*window, QStringLiteral("iron"), dress);
  }
}

TEST_F(Pictures, showAFloorPlanAndALengthWhole) {
  const QString path = home.filePath("hall.tessera.json");
  auto site = floor::layNewFloor({"hall", floor::usualTileTypes().front(), 4, 3, false}).value();
  QImage plan{900, 600, QImage::Format_RGB32};
  plan.fill(Qt::white);
  {
    QPainter painter{&plan};
    painter.setPen(QPen{QColor{70, 70, 80}, 10});
    painter.drawRect(30, 30, 840, 540);
    painter.drawLine(600, 30, 600, 330);
    painter.setPen(QPen{QColor{150, 150, 160}, 4});
    for (const int x : {660, 720, 780}) painter.drawRect(x, 90, 30, 180);
    painter.drawArc(480, 330, 240, 240, 0, 90 * 16);
  }
  QByteArray bytes;
  QBuffer buffer{&bytes};
  ASSERT_TRUE(buffer.open(QIODevice::WriteOnly));
  ASSERT_TRUE(plan.save(&buffer, "PNG"));
  floor::Backdrop backdrop;
  backdrop.file = "plan.png";
  backdrop.picture = std::make_shared<const std::string>(bytes.toStdString());
  backdrop.pixel = Metres{0.005};
  backdrop.origin = {Metres{-0.8}, Metres{-0.6}};
  site.backdrop = backdrop;
  ASSERT_TRUE(floor::saveSite(site, path.toStdString()));
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  ASSERT_TRUE(window->files().open(path));
  for (const Dress& dress : kDresses) {
    wear(dress);
    trigger("floorPlan");
    take(*window, QStringLiteral("plan"), dress);
    trigger("measure");
    clickFloor(0.6, 0.6);
    clickFloor(2.4, 0.6);
    clickFloor(2.4, 1.8);
    take(*window, QStringLiteral("length"), dress);
  }
}

}  // namespace
}  // namespace tessera::desktop
