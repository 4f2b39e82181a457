// What stands there before there is anything to see: the window on the screen it has, the views of a site without
// tiles, vehicles or a connection.
#include <QLabel>
#include <QScreen>

#include "app/desktop/desktop_fixture.h"
#include "app/tessera/site_files.h"
#include "floor/new_floor.h"
#include "floor/site_json.h"

namespace tessera::desktop {
namespace {

class FirstLook : public DesktopTest {
protected:
  /// A window as the program opens it, without the size that tests give it.
  void openAsTheProgramDoes() {
    window = std::make_unique<MainWindow>();
    window->restore();
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
  }
  [[nodiscard]] QRect room() const { return window->screen()->availableGeometry(); }
  void openSiteOf(floor::Site site, const char* name) {
    const QString path = home.filePath(QString::fromLatin1(name));
    ASSERT_TRUE(floor::saveSite(site, path.toStdString()));
    ASSERT_TRUE(window->files().open(path));
  }
  [[nodiscard]] std::string shown(const char* label) const { return find<QLabel>(label)->text().toStdString(); }
};

TEST_F(FirstLook, takesNoMoreThanTheScreenHas) {
  ASSERT_NO_FATAL_FAILURE(openAsTheProgramDoes());
  const QSize least = window->minimumSizeHint();
  EXPECT_LE(window->width(), std::max(room().width(), least.width()));
  EXPECT_LE(window->height(), std::max(room().height(), least.height()));
  EXPECT_GE(window->width(), std::min(room().width(), 1280)) << "and no less, where it would like more";
  EXPECT_TRUE(room().contains(window->geometry().topLeft()));
}

TEST_F(FirstLook, comesBackFromWhereThereIsNoScreenAnyMore) {
  ASSERT_NO_FATAL_FAILURE(openAsTheProgramDoes());
  window->setGeometry(5000, 4000, 2600, 1900);
  ASSERT_TRUE(closeWindow());
  ASSERT_NO_FATAL_FAILURE(openAsTheProgramDoes());
  EXPECT_TRUE(room().contains(window->geometry().topLeft()));
  const QSize least = window->minimumSizeHint();
  EXPECT_LE(window->width(), std::max(room().width(), least.width()));
  EXPECT_LE(window->height(), std::max(room().height(), least.height()));
}

TEST_F(FirstLook, staysInItsPlaceFromStartToStart) {
  ASSERT_NO_FATAL_FAILURE(openAsTheProgramDoes());
  const QRect before{20, 40, 770, 720};
  ASSERT_TRUE(room().contains(before)) << "the offscreen screen";
  window->setGeometry(before);
  for (int n = 1; n <= 3; ++n) {
    ASSERT_TRUE(closeWindow());
    ASSERT_NO_FATAL_FAILURE(openAsTheProgramDoes());
    EXPECT_EQ(window->geometry(), before) << "start " << n;
  }
}

TEST_F(FirstLook, saysOfWhatIsEmptyHowToGoOn) {
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  floor::Site site;
  site.name = "empty";
  ASSERT_NO_FATAL_FAILURE(openSiteOf(site, "empty.tessera.json"));
  EXPECT_NE(shown("chartsHint").find("Set one up"), std::string::npos) << shown("chartsHint");
  EXPECT_NE(shown("tileCheckHint").find("Lay tiles in the tool bar"), std::string::npos) << shown("tileCheckHint");
  EXPECT_EQ(shown("portLabel"), "Not connected");
  EXPECT_TRUE(find("portLabel")->toolTip().contains("Connect…"));
  ASSERT_TRUE(window->files().openDemo());
  EXPECT_NE(shown("chartsHint").find("Connect to the vehicles"), std::string::npos) << shown("chartsHint");
}

TEST_F(FirstLook, saysThatAnotherSiteIsNotConnectedThoughTheLastOneWas) {
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  ASSERT_NO_FATAL_FAILURE(startDemo());
  ASSERT_NO_FATAL_FAILURE(openSiteOf(floor::layNewFloor({"hall", floor::usualTileTypes().front(), 4, 3, false}).value(),
                                     "hall.tessera.json"));
  ASSERT_TRUE(until([&] { return window->session().state() == FleetSession::State::Off; }));
  EXPECT_TRUE(until([&] { return shown("portLabel") == "Not connected"; })) << shown("portLabel");
  window->setLanguage(QStringLiteral("zh_CN"));
  EXPECT_TRUE(until([&] { return shown("portLabel") == "未连接"; })) << shown("portLabel");
}

}  // namespace
}  // namespace tessera::desktop
