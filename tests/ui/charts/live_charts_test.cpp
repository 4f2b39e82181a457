#include "ui/charts/live_charts.h"

#include <gtest/gtest.h>
#include <qcustomplot.h>

#include <QFileDialog>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolTip>

#include "ui/fleet/fake_fleet.h"

namespace tessera::ui {
namespace {

class LiveChartsTest : public testing::Test {
protected:
  LiveChartsTest() {
    openFakeSite(document, 2, {"one"});
    charts.resize(1000, 500);
    charts.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&charts));
  }

  // Number 1 along the route at 0.3 m/s, 2 cm to the left of it; number 2 stands.
  void drive(double from, double to) {
    for (double t = from; t < to - 1e-9; t += 0.05) {
      auto snapshot = fakeSnapshot(2, t);
      auto& v = snapshot.vehicles[0];
      setRunning(v, "one", 0.3 * (t - 10.0), 4.0);
      v.crossTrack = Metres{0.02};
      v.pose = {{Metres{0.3 * (t - 10.0)}, Metres{0.02}}, Radians{0.0}};
      link.show(snapshot);
    }
  }
  [[nodiscard]] QCustomPlot* plot(const char* name) const { return charts.findChild<QCustomPlot*>(name); }
  [[nodiscard]] QCPGraph* graph(int index) const { return plot("timeChart")->graph(index); }
  [[nodiscard]] QToolButton* button(const char* name) const { return charts.findChild<QToolButton*>(name); }
  [[nodiscard]] bool showsCharts() const { return plot("timeChart")->isVisible(); }
  bool waitForPoints(int count) {
    return QTest::qWaitFor([&] { return graph(0)->dataCount() == count; });
  }

  FakeFleet link;
  Selection selection;
  SiteDocument document;
  LiveCharts charts{link, selection, document};
};

TEST_F(LiveChartsTest, AsksToChooseAVehicle) {
  drive(10.0, 11.0);
  EXPECT_FALSE(showsCharts());
  EXPECT_TRUE(charts.findChild<QLabel*>("chartsHint")->isVisible());
  selection.setVehicle(VehicleId{1});
  EXPECT_TRUE(showsCharts());
  EXPECT_EQ(charts.findChild<QLabel*>("chartedVehicle")->text(), "AGV 1");
  selection.setVehicle(std::nullopt);
  EXPECT_FALSE(showsCharts());
}

TEST_F(LiveChartsTest, ChartsErrorAndSpeedsOfTheChosenVehicle) {
  selection.setVehicle(VehicleId{1});
  drive(10.0, 15.0);
  ASSERT_TRUE(waitForPoints(100));
  EXPECT_EQ(charts.samples().size(), 100U);
  const auto error = graph(0)->data();
  EXPECT_NEAR(error->at(50)->value, 2.0, 1e-3) << "in cm";
  EXPECT_NEAR(error->at(99)->key, 14.95, 1e-6);
  EXPECT_NEAR(graph(1)->data()->at(50)->value, 0.3, 1e-6) << "commanded";
  EXPECT_NEAR(graph(2)->data()->at(50)->value, 0.3, 1e-6) << "reported";
  const QCPRange time = plot("timeChart")->axisRect(0)->axis(QCPAxis::atBottom)->range();
  EXPECT_NEAR(time.upper, 14.95, 1e-6);
  EXPECT_NEAR(time.size(), 60.0, 1e-6);
}

TEST_F(LiveChartsTest, DrawsTrackAndRouteToScale) {
  selection.setVehicle(VehicleId{1});
  drive(10.0, 15.0);
  ASSERT_TRUE(waitForPoints(100));
  auto* track = plot("trackChart");
  auto* route = qobject_cast<QCPCurve*>(track->plottable(0));
  auto* driven = qobject_cast<QCPCurve*>(track->plottable(1));
  ASSERT_NE(route, nullptr);
  ASSERT_NE(driven, nullptr);
  EXPECT_EQ(route->dataCount(), 3);
  EXPECT_EQ(driven->dataCount(), 100);
  for (const QSize size : {QSize{1000, 500}, QSize{500, 900}, QSize{1200, 300}}) {
    charts.resize(size);
    track->replot(QCustomPlot::rpImmediateRefresh);
    const double across = track->xAxis->range().size() / track->axisRect()->width();
    const double up = track->yAxis->range().size() / track->axisRect()->height();
    EXPECT_NEAR(across / up, 1.0, 0.02);
    EXPECT_LE(track->xAxis->range().lower, 0.0);
    EXPECT_GE(track->xAxis->range().upper, 3.0);
    EXPECT_GE(track->yAxis->range().upper, 1.0);
  }
}

TEST_F(LiveChartsTest, KeepsTheOthersSamplesForWhenTheyAreChosen) {
  selection.setVehicle(VehicleId{2});
  drive(10.0, 15.0);
  selection.setVehicle(VehicleId{1});
  EXPECT_EQ(graph(0)->dataCount(), 100);
}

TEST_F(LiveChartsTest, ShowsTheTimeThatIsAskedFor) {
  selection.setVehicle(VehicleId{1});
  drive(10.0, 100.0);
  auto* window = charts.findChild<QComboBox*>("timeWindow");
  window->setFocus();
  QTest::keyClick(window, Qt::Key_Up);
  EXPECT_EQ(window->currentText(), "30 s");
  EXPECT_NEAR(charts.samples().front().time, 99.95 - 30.0, 0.1);
  QTest::keyClick(window, Qt::Key_End);
  EXPECT_EQ(window->currentText(), "15 min");
  EXPECT_NEAR(charts.samples().front().time, 10.0, 0.6);
}

TEST_F(LiveChartsTest, HoldsStillAndGoesOn) {
  selection.setVehicle(VehicleId{1});
  drive(10.0, 12.0);
  ASSERT_TRUE(waitForPoints(40));
  QTest::mouseClick(button("holdChartsButton"), Qt::LeftButton);
  drive(12.0, 14.0);
  EXPECT_EQ(charts.samples().size(), 40U);
  EXPECT_TRUE(plot("timeChart")->interactions().testFlag(QCP::iRangeZoom));
  QTest::mouseClick(button("holdChartsButton"), Qt::LeftButton);
  EXPECT_EQ(charts.samples().size(), 80U);
  EXPECT_FALSE(plot("timeChart")->interactions().testFlag(QCP::iRangeZoom));
}

TEST_F(LiveChartsTest, ClearsTheChosenVehicleOnly) {
  drive(10.0, 12.0);
  selection.setVehicle(VehicleId{1});
  QTest::mouseClick(button("clearChartsButton"), Qt::LeftButton);
  EXPECT_TRUE(charts.samples().empty());
  EXPECT_FALSE(showsCharts());
  selection.setVehicle(VehicleId{2});
  EXPECT_EQ(charts.samples().size(), 40U);
}

TEST_F(LiveChartsTest, TellsValuesUnderTheMouse) {
  selection.setVehicle(VehicleId{1});
  drive(10.0, 15.0);
  ASSERT_TRUE(waitForPoints(100));
  auto* time = plot("timeChart");
  time->replot(QCustomPlot::rpImmediateRefresh);
  const double x = time->axisRect(0)->axis(QCPAxis::atBottom)->coordToPixel(13.0);
  QTest::mouseMove(time, QPoint{static_cast<int>(x), time->axisRect(0)->center().y()});
  ASSERT_TRUE(QTest::qWaitFor([] { return QToolTip::isVisible(); }));
  EXPECT_TRUE(QToolTip::text().contains(QLocale{}.toString(2.0, 'f', 1) + " cm")) << QToolTip::text().toStdString();
}

TEST_F(LiveChartsTest, SavesPicturesAndValues) {
  selection.setVehicle(VehicleId{1});
  drive(10.0, 15.0);
  ASSERT_TRUE(waitForPoints(100));
  const QTemporaryDir folder;
  EXPECT_EQ(charts.saveTo(folder.filePath("drive.png")), QString{});
  const QImage picture{folder.filePath("drive.png")};
  EXPECT_EQ(picture.size(), QSize(2200, 1120));
  EXPECT_EQ(picture.pixelColor(1, 1), QColor{Qt::white});
  EXPECT_EQ(charts.saveTo(folder.filePath("drive.pdf")), QString{});
  QFile pdf{folder.filePath("drive.pdf")};
  ASSERT_TRUE(pdf.open(QIODevice::ReadOnly));
  EXPECT_TRUE(pdf.read(5).startsWith("%PDF-"));
  EXPECT_EQ(charts.saveTo(folder.filePath("drive.csv")), QString{});
  QFile values{folder.filePath("drive.csv")};
  ASSERT_TRUE(values.open(QIODevice::ReadOnly | QIODevice::Text));
  const QList<QByteArray> lines = values.readAll().trimmed().split('\n');
  ASSERT_EQ(lines.size(), 101);
  EXPECT_EQ(lines[0], "time_s,x_m,y_m,heading_deg,cross_track_m,speed_mps,commanded_mps");
  EXPECT_EQ(lines[1], "10.000,0.0000,0.0200,0.00,0.0200,0.3000,0.3000");
  EXPECT_NE(charts.saveTo("/nowhere/at/all/drive.csv"), QString{});
  EXPECT_NE(charts.saveTo("/nowhere/at/all/drive.png"), QString{});
}

TEST_F(LiveChartsTest, AsksForAFileAndSavesThere) {
  selection.setVehicle(VehicleId{1});
  drive(10.0, 15.0);
  ASSERT_TRUE(waitForPoints(100));
  const QTemporaryDir folder;
  QTimer::singleShot(0, &charts, [&] {
    auto* dialog = charts.findChild<QFileDialog*>("saveChartsDialog");
    ASSERT_NE(dialog, nullptr);
    dialog->setDirectory(folder.path());
    auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
    name->setText("mine");
    QTest::keyClick(name, Qt::Key_Return);
  });
  QTest::mouseClick(button("saveChartsButton"), Qt::LeftButton);
  EXPECT_TRUE(QFile::exists(folder.filePath("mine.png")));
}

TEST_F(LiveChartsTest, DrawsNothingWhileHidden) {
  selection.setVehicle(VehicleId{1});
  drive(10.0, 11.0);
  ASSERT_TRUE(waitForPoints(20));
  charts.hide();
  drive(11.0, 12.0);
  EXPECT_EQ(graph(0)->dataCount(), 20);
  charts.show();
  EXPECT_EQ(graph(0)->dataCount(), 40);
}

}  // namespace
}  // namespace tessera::ui
