// Finding, measuring, importing and exporting in the whole window, by mouse and keyboard.
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QStatusBar>
#include <QUndoView>

#include "app/desktop/desktop_fixture.h"
#include "app/tessera/exchange_files.h"
#include "app/tessera/site_files.h"
#include "floor/site_json.h"
#include "ui/find/find_box.h"

namespace tessera::desktop {
namespace {

class Looking : public DesktopTest {
protected:
  void SetUp() override {
    openWindow(false);
    const auto demo = SiteFiles::demoPath();
    ASSERT_TRUE(demo) << demo.error().sentence;
    ASSERT_TRUE(window->files().open(*demo));
  }
  [[nodiscard]] const floor::Site& site() const { return window->document().site(); }
  [[nodiscard]] QString written(const char* name, const QByteArray& text) const {
    QFile file{home.filePath(QString::fromLatin1(name))};
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
    return file.fileName();
  }
};

TEST_F(Looking, goesToATileByItsSerialNumber) {
  press(Qt::Key_F, Qt::ControlModifier);
  auto* text = find<QLineEdit>("findText");
  ASSERT_TRUE(until([&] { return text->hasFocus(); }));
  const QString serial = QString::fromStdString(site().placements.back().serial);
  QTest::keyClicks(text, serial);
  QTest::keyClick(text, Qt::Key_Return);
  EXPECT_FALSE(find("findBox")->isVisible());
  const Point corner = site().placements.back().origin;
  const QPoint seen = pixelOf(corner.x.value() + 0.3, corner.y.value() + 0.3);
  EXPECT_LT((seen - window->canvas().rect().center()).manhattanLength(), 30) << "it is in the middle";
  EXPECT_TRUE(window->canvas().hasFocus());
  const ui::SiteBox ring = window->canvas().ringed();
  EXPECT_LT(distance(ring.low, corner), Metres{1e-6}) << "the tile, and nothing of its neighbours";
  QTest::keyClick(&window->canvas(), Qt::Key_Escape);
  EXPECT_TRUE(window->canvas().ringed().empty());
}

TEST_F(Looking, ringsWhatWasAskedForUntilTheNextClick) {
  const std::string uid = site().tiles.front().uids.front().text();
  const auto ink = [this](QPoint around) {
    window->canvas().finishDrawing();
    const QImage image = window->canvas().grab().toImage();
    const double ratio = image.devicePixelRatio();
    return image.copy(QRect{(QPointF{around - QPoint{20, 20}} * ratio).toPoint(), QSize{40, 40} * ratio});
  };
  press(Qt::Key_F, Qt::ControlModifier);
  auto* text = find<QLineEdit>("findText");
  ASSERT_TRUE(until([&] { return text->hasFocus(); }));
  QTest::keyClicks(text, QString::fromStdString(uid));
  QTest::keyClick(text, Qt::Key_Return);
  const QPoint middle = window->canvas().rect().center();
  const QImage ringed = ink(middle);
  QTest::mouseClick(&window->canvas(), Qt::LeftButton, {}, middle + QPoint{0, 150});
  EXPECT_TRUE(window->canvas().ringed().empty());
  EXPECT_NE(ringed, ink(middle)) << "the ring is seen";
}

class LookingAtNothing : public DesktopTest {};

TEST_F(LookingAtNothing, offersNothingThatNeedsASite) {
  openWindow(false);
  for (const char* name : {"importFile", "exportFile", "mapPicture", "find", "measure"})
    EXPECT_FALSE(find<QAction>(name)->isEnabled()) << name;
}

TEST_F(Looking, measuresBesideTheOtherTools) {
  press(Qt::Key_M, Qt::ControlModifier);
  EXPECT_TRUE(find<QAction>("measure")->isChecked());
  EXPECT_FALSE(find<QAction>("browse")->isChecked());
  clickFloor(0.6, 0.6);
  clickFloor(1.2, 0.6);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(window->isWindowModified());
  QTest::keyClick(&window->canvas(), Qt::Key_Escape);
  QTest::keyClick(&window->canvas(), Qt::Key_Escape);
  EXPECT_TRUE(find<QAction>("browse")->isChecked());
}

TEST_F(Looking, importsATableAsOneStepThatCanBeUndone) {
  const floor::Site before = site();
  const QString table = written("loose.csv", "x_m,y_m,uid\n0.31,0.32,04A1B2C3D4E5F6\n");
  auto* exchange = window->findChild<ExchangeFiles*>();
  ASSERT_NE(exchange, nullptr);
  inDialogue(QStringLiteral("changesDialog"), [](QDialog& dialog) { QTest::keyClick(&dialog, Qt::Key_Escape); });
  EXPECT_FALSE(exchange->importFrom(table));
  EXPECT_EQ(site(), before) << "nothing before it is agreed to";
  inDialogue(QStringLiteral("changesDialog"), [](QDialog& dialog) {
    EXPECT_EQ(dialog.findChild<QListWidget*>("changesList")->count(), 1);
    QTest::keyClick(&dialog, Qt::Key_Return);
  });
  EXPECT_TRUE(exchange->importFrom(table));
  ASSERT_EQ(site().looseTags.size(), before.looseTags.size() + 1);
  EXPECT_EQ(window->document().undoStack().count(), 1);
  trigger("undo");
  EXPECT_EQ(site(), before);
}

TEST_F(Looking, addsAnotherSiteAsOneStepThatCanBeUndone) {
  const floor::Site before = site();
  floor::Site other = before;
  other.tiles.resize(2);
  other.placements.clear();
  for (floor::Tile& tile : other.tiles) {
    tile.serial = "X" + tile.serial;
    tile.uids.clear();
    other.placements.push_back({tile.serial, {Metres{30.0 + static_cast<double>(other.placements.size())}, {}}, 0});
  }
  other.looseTags.clear();
  other.routes.resize(1);
  other.routes[0].vertices[0].x = Metres{0.7};  // another way under the same name
  const QString file = written("other.tessera.json", floor::writeSite(other).c_str());
  auto* exchange = window->findChild<ExchangeFiles*>();
  inDialogue(QStringLiteral("changesDialog"), [&](QDialog& dialog) {
    EXPECT_EQ(dialog.findChild<QListWidget*>("changesList")->count(), 4);
    auto* notes = dialog.findChild<QListWidget*>("changesNotes");
    ASSERT_EQ(notes->count(), 1);
    EXPECT_TRUE(notes->item(0)->text().contains("is here already")) << notes->item(0)->text().toStdString();
    QTest::mouseClick(dialog.findChild<QWidget*>("changesTake"), Qt::LeftButton);
  });
  EXPECT_TRUE(exchange->importFrom(file));
  EXPECT_EQ(site().placements.size(), before.placements.size() + 2);
  EXPECT_EQ(site().routes, before.routes);
  EXPECT_EQ(window->document().undoStack().count(), 1);
  trigger("undo");
  EXPECT_EQ(site(), before);
}

TEST_F(Looking, tellsOfAFileThatCannotBeImported) {
  const floor::Site before = site();
  auto* exchange = window->findChild<ExchangeFiles*>();
  for (const char* text : {"", "serial,index,uid\nT-0001,1,XYZ\n", "\"", "{}"}) {
    QString told;
    inDialogue(QStringLiteral("exchangeTrouble"), [&](QDialog& dialog) { told = dialog.windowTitle(); });
    EXPECT_FALSE(exchange->importFrom(written("bad.csv", text)));
    EXPECT_FALSE(told.isEmpty()) << text;
  }
  EXPECT_EQ(site(), before);
}

TEST_F(Looking, bringsBackWhatItExported) {
  auto* exchange = window->findChild<ExchangeFiles*>();
  const QString file = home.filePath("tags.csv");
  ASSERT_TRUE(exchange->exportTo(file));
  EXPECT_EQ(window->statusBar()->currentMessage(), "tags.csv was written.");
  inDialogue(QStringLiteral("changesDialog"), [](QDialog& dialog) {
    EXPECT_EQ(dialog.findChild<QWidget*>("changesTake"), nullptr) << "nothing would change";
  });
  EXPECT_FALSE(exchange->importFrom(file));
  const QString places = home.filePath("tags.places.csv");
  ASSERT_TRUE(exchange->exportTo(places));
  EXPECT_EQ(QFile{places}.size() > 1000, true) << "tags of tiles as well";
  inDialogue(QStringLiteral("changesDialog"), [](QDialog& dialog) {
    EXPECT_EQ(dialog.findChild<QWidget*>("changesTake"), nullptr) << "nothing would change";
    EXPECT_EQ(dialog.findChild<QListWidget*>("changesNotes")->count(), 1) << "which tags are tiles'";
  });
  EXPECT_FALSE(exchange->importFrom(places));
  inDialogue(QStringLiteral("exportNotes"), [](QDialog& dialog) { QTest::keyClick(&dialog, Qt::Key_Return); });
  EXPECT_TRUE(exchange->exportTo(home.filePath("site.lif.json")));
  EXPECT_TRUE(QFile::exists(home.filePath("site.lif.json")));
}

TEST_F(Looking, listsTheStepsAndGoesBackToOneThatIsClicked) {
  drawRoute({{0.3, 0.3}, {0.3, 1.5}});
  drawRoute({{0.9, 0.3}, {0.9, 1.5}});
  const std::size_t all = site().routes.size();
  auto* steps = window->findChild<QUndoView*>();
  ASSERT_NE(steps, nullptr);
  EXPECT_EQ(steps->model()->rowCount(), 3) << "the beginning and two steps";
  steps->setCurrentIndex(steps->model()->index(1, 0));
  EXPECT_EQ(site().routes.size(), all - 1);
}

}  // namespace
}  // namespace tessera::desktop
