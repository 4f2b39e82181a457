// Pictures of the views that an operator has, and of the dialogues.
#include "app/desktop/pictures.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QDockWidget>
#include <QScrollArea>
#include <QTabWidget>

#include "app/tessera/register_desk.h"
#include "app/tessera/site_files.h"
#include "floor/new_floor.h"
#include "floor/site_json.h"
#include "ui/canvas/floor_canvas.h"
#include "ui/commission/commission_wizard.h"
#include "ui/commission/jog_dialog.h"
#include "ui/connect/connect_dialog.h"
#include "ui/help/about_dialog.h"
#include "ui/help/help_window.h"

namespace tessera::desktop {
namespace {

TEST_F(Pictures, showTheStartPageWhole) {
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  for (const Dress& dress : kDresses) {
    wear(dress);
    take(*window, QStringLiteral("start"), dress);
  }
}

TEST_F(Pictures, showADriveWhole) {
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  ASSERT_NO_FATAL_FAILURE(startDemo());
  pressWhenOffered("runAction", Qt::Key_F5);
  ASSERT_TRUE(until([&] { return vehicle().progress > Metres{0.9}; })) << vehicle().waits.english();
  for (const Dress& dress : kDresses) {
    wear(dress);
    for (const auto& [dock, view] :
         {std::pair{"vehiclesDock", "drive"}, {"chartsDock", "charts"}, {"eventsDock", "events"}}) {
      find<QDockWidget>(dock)->raise();
      take(*window, QString::fromLatin1(view), dress);
    }
  }
}

TEST_F(Pictures, showTheJournalWhole) {
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  ASSERT_NO_FATAL_FAILURE(startDemo());
  find("eventsDock")->raise();
  QTest::mouseClick(find("byDayButton"), Qt::LeftButton);
  const auto* list = find<QAbstractItemView>("eventList")->model();
  ASSERT_TRUE(until([&] { return find("backToNow")->isVisible() && find("showAllButton")->isVisible(); }));
  for (const Dress& dress : kDresses) {
    wear(dress);
    take(*window, QStringLiteral("journal-empty"), dress);
  }
  QTest::mouseClick(find("dayAfter"), Qt::LeftButton);
  ASSERT_TRUE(until([&] { return list->rowCount() > 0; })) << "today has events";
  for (const Dress& dress : kDresses) {
    wear(dress);
    take(*window, QStringLiteral("journal"), dress);
  }
}

TEST_F(Pictures, showTheRouteToolWhole) {
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  ASSERT_TRUE(window->files().openDemo());
  for (const Dress& dress : kDresses) {
    wear(dress);
    trigger("drawRoute");
    clickFloor(0.3, 0.3);
    clickFloor(0.3, 1.5);
    QTest::mouseMove(&window->canvas(), pixelOf(1.2, 1.2));
    take(*window, QStringLiteral("route"), dress);
    QTest::keyClick(&window->canvas(), Qt::Key_Escape);
  }
}

TEST_F(Pictures, showZonesAndFaultsWhole) {
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  ASSERT_TRUE(window->files().openDemo());
  trigger("drawZone");  // no-go, upon the demo's route: an error with a place
  const QPoint from = pixelOf(0.6, 0.6);
  QTest::mousePress(&window->canvas(), Qt::LeftButton, {}, from);
  for (int n = 1; n <= 5; ++n) QTest::mouseMove(&window->canvas(), from + (pixelOf(1.2, 1.2) - from) * n / 5);
  QTest::mouseRelease(&window->canvas(), Qt::LeftButton, {}, pixelOf(1.2, 1.2));
  trigger("showFaults");
  auto* faults = find<QAbstractItemView>("faultList");
  ASSERT_TRUE(until([&] { return faults->model()->index(0, 0).data().toString().contains("no-go"); }));
  faults->setCurrentIndex(faults->model()->index(0, 0));
  for (const Dress& dress : kDresses) {
    wear(dress);
    take(*window, QStringLiteral("zones"), dress);
    trigger("drawRoute");
    clickFloor(0.3, 0.9);
    QTest::mouseMove(&window->canvas(), pixelOf(1.5, 0.9));
    (void)QTest::qWaitFor([] { return false; }, 500);
    take(*window, QStringLiteral("route-fault"), dress);
    trigger("editZones");
  }
}

TEST_F(Pictures, showRegisteringWhole) {
  const QString path = home.filePath("hall.tessera.json");
  const auto site = floor::layNewFloor({"hall", floor::usualTileTypes().front(), 4, 3, false}).value();
  ASSERT_TRUE(floor::saveSite(site, path.toStdString()));
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  ASSERT_TRUE(window->files().open(path));
  auto& registrar = window->registerDesk().registrar();
  const auto read = [&](unsigned n) {
    const std::array<std::uint8_t, 4> bytes{4, 0, 0, static_cast<std::uint8_t>(n)};
    registrar.take(scan::TagRead{floor::TagUid::fromBytes(bytes).value(), std::nullopt});
  };
  for (const Dress& dress : kDresses) {
    wear(dress);
    trigger("registerTags");
    take(*window, QStringLiteral("register-setup"), dress);
    registrar.start({}, {true, {}, 9600, scan::ReaderForm::HexLines, false});
    for (unsigned n = 1; n <= 11; ++n) read(n);
    registrar.skip();
    take(*window, QStringLiteral("register"), dress);
    read(3);
    take(*window, QStringLiteral("register-refused"), dress);
    registrar.end();
    window->document().undoStack().setIndex(0);
  }
}

TEST_F(Pictures, showRevisionsWhole) {
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  ASSERT_TRUE(window->files().openDemo());
  auto* table = find<QAbstractItemView>("revisionTable");
  auto* list = find<QAbstractItemView>("revisionDifferences");
  ASSERT_TRUE(until([&] { return table->model()->rowCount() == 1; }));
  // Something of each kind: a tile gone, one elsewhere, a route come, a zone's speed.
  ASSERT_TRUE(window->document().edit("Take up and move tiles", [](floor::Site& site) {
    site.placements.erase(site.placements.begin(), site.placements.begin() + 2);
    site.placements.back().origin = site.placements.back().origin + Offset{Metres{1.2}, Metres{0.4}};
    site.tiles.at(4).uids.at(0) = {};
    site.routes.push_back({"round", {{Metres{0.3}, Metres{1.6}}, {Metres{2.0}, Metres{1.6}}}, Metres{0.2}});
  }));
  trigger("save");
  ASSERT_TRUE(until([&] { return table->model()->rowCount() == 2; }));
  trigger("showRevisions");
  table->setCurrentIndex(table->model()->index(1, 0));
  ASSERT_TRUE(until([&] { return list->model()->rowCount() > 3; }));
  list->setCurrentIndex(list->model()->index(0, 0));
  for (const Dress& dress : kDresses) {
    wear(dress);
    take(*window, QStringLiteral("revisions"), dress);
  }
}

TEST_F(Pictures, showTheEditorsOtherToolsWhole) {
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  ASSERT_TRUE(window->files().openDemo());
  for (const Dress& dress : kDresses) {
    wear(dress);
    for (const char* tool : {"layTiles", "measure", "floorPlan", "tileCheck", "locating", "calibrate", "compass"}) {
      trigger(tool);
      take(*window, QString::fromLatin1(tool), dress);
    }
  }
}

TEST_F(Pictures, showTheDialoguesWhole) {
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  ASSERT_TRUE(window->files().openDemo());
  for (const Dress& dress : kDresses) {
    wear(dress);
    ui::ConnectDialog connectDialog{window.get()};
    connectDialog.show();
    take(connectDialog, QStringLiteral("connect"), dress);
    ui::AboutDialog about{window.get()};
    about.show();
    take(about, QStringLiteral("about"), dress);
    ui::HelpWindow help{window.get()};
    help.showTopic(QStringLiteral("routes"));
    help.show();
    take(help, QStringLiteral("help"), dress);
  }
}

TEST_F(Pictures, showTheBoxesThatAskWhole) {
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  ASSERT_NO_FATAL_FAILURE(startDemo());
  ASSERT_TRUE(window->document().edit("Rename", [](floor::Site& site) { site.name += " 2"; }));
  for (const Dress& dress : kDresses) {
    wear(dress);
    trigger("jog");
    auto* jog = window->findChild<ui::JogDialog*>();
    ASSERT_TRUE(until([&] { return jog->isVisible(); }));
    take(*jog, QStringLiteral("jog"), dress);
    jog->close();
    const auto inBox = [&](const char* name, const char* view) {
      inDialogue(QString::fromLatin1(name), [this, view, &dress](QDialog& box) {
        take(box, QString::fromLatin1(view), dress);
        QTest::keyClick(&box, Qt::Key_Escape);
      });
    };
    inBox("saveQuestion", "question-save");
    EXPECT_FALSE(window->files().mayLeave());
    inBox("radioDialog", "radio");
    trigger("radio");
    inBox("siteDialog", "site");
    trigger("siteProperties");
    inDialogue(QStringLiteral("siteDialog"), [this, &dress](QDialog& box) {
      box.findChild<QTabWidget*>()->setCurrentIndex(1);
      box.findChild<QAbstractButton*>(QStringLiteral("addLooseTag"))->click();
      take(box, QStringLiteral("site-tags"), dress);
      QTest::keyClick(&box, Qt::Key_Escape);
    });
    trigger("siteProperties");
  }
}

TEST_F(Pictures, showTheNewSiteBoxWhole) {
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  for (const Dress& dress : kDresses) {
    wear(dress);
    inDialogue(QStringLiteral("newSiteDialog"),
               [this, &dress](QDialog& dialog) { take(dialog, QStringLiteral("new-site"), dress); });
    EXPECT_FALSE(window->files().create());
  }
}

TEST_F(Pictures, showEachPageOfTheWizardWhole) {
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  ASSERT_NO_FATAL_FAILURE(startDemo());
  for (const Dress& dress : kDresses) {
    wear(dress);
    ui::CommissionWizard wizard{window->session(), window->document(), vehicle().id, window.get()};
    wizard.show();
    for (const int id : wizard.pageIds()) {
      while (wizard.currentId() != id && wizard.nextId() != -1) wizard.next();
      take(wizard, QStringLiteral("wizard-%1").arg(id), dress);
    }
  }
}

}  // namespace
}  // namespace tessera::desktop
