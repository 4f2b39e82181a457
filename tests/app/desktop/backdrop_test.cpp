// A floor plan in the whole window: chosen, scaled by two points, moved, saved, opened again, and undone to nothing.
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPainter>
#include <QPushButton>

#include "app/desktop/desktop_fixture.h"
#include "app/tessera/backdrop_desk.h"
#include "app/tessera/site_files.h"

namespace tessera::desktop {
namespace {

class FloorPlanInWindow : public DesktopTest {
protected:
  void SetUp() override {
    openWindow(false);
    ASSERT_TRUE(QFile::copy(QStringLiteral(TESSERA_SITES "/paper.tessera.json"), path("hall.tessera.json")));
    ASSERT_TRUE(window->files().open(path("hall.tessera.json")));
    QApplication::processEvents();
    QImage image{600, 400, QImage::Format_RGB32};
    image.fill(Qt::white);
    QPainter{&image}.fillRect(100, 100, 400, 200, Qt::darkGreen);
    ASSERT_TRUE(image.save(path("Halle 3.png")));
  }
  [[nodiscard]] QString path(const QString& name) const { return home.filePath(name); }
  [[nodiscard]] const std::optional<floor::Backdrop>& plan() const { return window->document().site().backdrop; }
  /// Through the panel's button and the dialogue, as a person does.
  void choose(const char* button, const QString& file) {
    inDialogue(QStringLiteral("QFileDialog"), [&](QDialog& dialog) {
      auto* name = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
      ASSERT_NE(name, nullptr);
      name->setText(file);
      QTest::keyClick(name, Qt::Key_Return);
    });
    QTest::mouseClick(find(button), Qt::LeftButton);
    // A desktop does so by itself after a dialogue; this platform without one does not.
    window->activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(window.get()));
  }
};

TEST_F(FloorPlanInWindow, isAddedScaledSavedOpenedEqualAndUndoneToNothing) {
  const floor::Site before = window->document().site();
  EXPECT_TRUE(find<QDockWidget>("backdropDock")->isHidden());
  press(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(find<QAction>("floorPlan")->isChecked());
  ASSERT_TRUE(until([&] { return find("chooseBackdrop")->isVisible(); }));
  choose("chooseBackdrop", path("Halle 3.png"));
  ASSERT_TRUE(plan());
  EXPECT_EQ(plan()->file, "Halle 3.png");
  ASSERT_TRUE(until([&] { return find("scaleBackdrop")->isVisible(); }));

  QTest::mouseClick(find("scaleBackdrop"), Qt::LeftButton);
  clickFloor(1, 2);
  clickFloor(5, 2);
  auto* distance = find<QDoubleSpinBox>("backdropDistance");
  ASSERT_TRUE(distance->isVisible());
  const double measured = distance->value();
  EXPECT_NEAR(measured, 4.0, 0.05);
  EXPECT_TRUE(distance->hasFocus()) << "the number is typed at once";
  QTest::keyClicks(distance, "2");
  QTest::keyClick(distance, Qt::Key_Return);
  EXPECT_NEAR(plan()->pixel.value(), 0.02 / measured, 0.0001);
  EXPECT_TRUE(window->canvas().hasFocus());
  QTest::keyClick(&window->canvas(), Qt::Key_Right, Qt::ShiftModifier);

  const floor::Site after = window->document().site();
  ASSERT_TRUE(window->files().save());
  ASSERT_TRUE(window->files().open(QStringLiteral(TESSERA_SITES "/paper.tessera.json")));
  EXPECT_FALSE(plan());
  ASSERT_TRUE(window->files().open(path("hall.tessera.json")));
  EXPECT_EQ(window->document().site(), after);
  EXPECT_FALSE(window->isWindowModified());

  press(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(until([&] { return find("removeBackdrop")->isVisible(); }));
  QTest::mouseClick(find("removeBackdrop"), Qt::LeftButton);
  EXPECT_EQ(window->document().site(), before);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(window->document().site(), after);
}

TEST_F(FloorPlanInWindow, isUndoneStepByStepToTheSiteWithoutIt) {
  const floor::Site before = window->document().site();
  press(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(until([&] { return find("chooseBackdrop")->isVisible(); }));
  choose("chooseBackdrop", path("Halle 3.png"));
  QTest::keyClick(&window->canvas(), Qt::Key_Up);
  EXPECT_EQ(window->document().undoStack().count(), 2);
  press(Qt::Key_Z, Qt::ControlModifier);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(window->document().site(), before);
  EXPECT_TRUE(find("chooseBackdrop")->isVisible());
}

TEST_F(FloorPlanInWindow, thatIsDamagedIsToldAndChangesNothing) {
  QFile file{path("torn.png")};
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("\x89PNG\r\n\x1A\ntorn");
  file.close();
  press(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(until([&] { return find("chooseBackdrop")->isVisible(); }));
  QString told;
  QTimer::singleShot(0, window.get(), [&] {
    until([] { return QApplication::activeModalWidget() != nullptr; });
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    ASSERT_NE(box, nullptr);
    told = box->text();
    box->accept();
  });
  EXPECT_FALSE(window->floorPlan().put(path("torn.png")));
  EXPECT_EQ(told, "torn.png: The picture is damaged or of a kind that cannot be shown.");
  EXPECT_FALSE(plan());
  EXPECT_FALSE(window->isWindowModified());
}

TEST_F(FloorPlanInWindow, isSwitchedOffInTheViewMenuAndOnAgainWithItsTool) {
  ASSERT_TRUE(window->floorPlan().put(path("Halle 3.png")));
  window->canvas().finishDrawing();
  const QPoint at = window->canvas().view().toPixel({Metres{5}, Metres{3.5}}).toPoint();
  const auto colour = [&] {
    window->canvas().finishDrawing();
    return window->canvas().grab().toImage().pixelColor(at);
  };
  const QColor shown = colour();
  trigger("layerBackdrop");
  EXPECT_NE(colour(), shown);
  trigger("floorPlan");
  EXPECT_EQ(colour(), shown);
}

}  // namespace
}  // namespace tessera::desktop
