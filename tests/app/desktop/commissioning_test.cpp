// A vehicle fresh from the factory is set up in the whole window, over the port of a simulated world that the window
// knows nothing else of.
#include <QLabel>

#include "app/desktop/new_vehicle.h"
#include "app/tessera/keeper.h"
#include "ui/connect/look.h"
#include "wire/pairing.h"

namespace tessera::desktop {
namespace {

TEST_F(NewVehicle, isSetUpFromItsTypeToItsFirstDrive) {
  ASSERT_TRUE(window->files().open(path()));
  ASSERT_NO_FATAL_FAILURE(connectToWorld());
  inDialogue(QStringLiteral("commissionWizard"), [this](QDialog& dialog) {
    auto& wizard = dynamic_cast<CommissionWizard&>(dialog);
    WizardHands hands{wizard};
    describe(hands, "Ant");

    ASSERT_NO_FATAL_FAILURE(pair(hands));
    EXPECT_EQ(filed().id, VehicleId{kNewAddress}) << "saved at once";
    EXPECT_EQ(filed().key, wizard.draft().key);
    EXPECT_NE(filed().key, wire::kFactoryKey);
    EXPECT_FALSE(hands.at<QAbstractButton>("saveKey").isVisible());
    hands.next();

    ASSERT_TRUE(nextOffered(hands)) << hands.at<Notice>("silence").text().toStdString();
    EXPECT_EQ(tone(hands, "contactResult"), Notice::Tone::Good);
    hands.next();

    ASSERT_TRUE(until([&] { return hands.at<QAbstractButton>("writeSettings").isEnabled(); }));
    hands.click("writeSettings");
    ASSERT_TRUE(nextOffered(hands)) << hands.at<Notice>("settingsResult").text().toStdString();
    hands.next();

    // Nobody holds tags under the readers of a simulated vehicle.
    ASSERT_TRUE(until([&] { return !hands.at<Notice>("readersResult").text().isEmpty(); }));
    EXPECT_EQ(tone(hands, "readersResult"), Notice::Tone::Info) << "they all answer";
    hands.skip();

    ASSERT_NO_FATAL_FAILURE(calibrateCompass(hands));
    ui::look::take(wizard, QStringLiteral("wizard-compass"));
    hands.next();

    ASSERT_NO_FATAL_FAILURE(jogOverTags(hands));
    hands.next();

    ASSERT_TRUE(until([&] { return hands.at<QAbstractButton>("firstRun").isEnabled(); }));
    hands.click("firstRun");
    ASSERT_TRUE(until([&] { return vehicle().task == supervisor::Task::Running && vehicle().progress > Metres{0.05}; }))
        << vehicle().waits.english() << vehicle().doing.english();
    hands.click("firstStop");
    ASSERT_TRUE(until([&] { return vehicle().speed == MetresPerSecond{}; }));
    hands.skip();
    EXPECT_EQ(wizard.currentId(), CommissionWizard::kSummary);
    hands.click("calibrateNext");
  });
  trigger("commission");
  EXPECT_TRUE(find("drawFigure")->isVisible()) << "readers and wheels come next";
  ASSERT_EQ(window->document().site().vehicles.size(), 1U);
  EXPECT_EQ(window->document().site().vehicles.back(), filed());
  EXPECT_EQ(filed().name, "Ant");
  EXPECT_FALSE(window->isWindowModified());
  EXPECT_EQ(window->selection().vehicle(), VehicleId{kNewAddress});
  EXPECT_EQ(vehicle().contact, supervisor::Contact::Connected);
}

TEST_F(NewVehicle, hasAKeyThatIsOfferedToBeSavedWhereOtherChangesAreNot) {
  ASSERT_TRUE(window->files().open(path()));
  ASSERT_NO_FATAL_FAILURE(connectToWorld());
  drawRoute({{0.3, 0.3}, {0.3, 1.5}});
  inDialogue(QStringLiteral("commissionWizard"), [this](QDialog& dialog) {
    auto& wizard = dynamic_cast<CommissionWizard&>(dialog);
    WizardHands hands{wizard};
    describe(hands, "Ant");
    ASSERT_NO_FATAL_FAILURE(pair(hands));
    EXPECT_TRUE(hands.at<QAbstractButton>("saveKey").isVisible());
    EXPECT_EQ(floor::loadSite(path().toStdString()).value(), hall) << "nobody has decided to save the route";
    ASSERT_TRUE(until([&] {
      const auto kept = window->keeper().unsaved(path());
      return kept && !kept->site().vehicles.empty() && kept->site().vehicles.back().key == wizard.draft().key;
    })) << "a crash now would not lose it";
    while (wizard.currentId() != CommissionWizard::kSummary) hands.skip();
    QTest::mouseClick(&hands.button(QWizard::FinishButton), Qt::LeftButton);
  });
  answerQuestion(QStringLiteral("saveKeyQuestion"), QStringLiteral("Save"));
  trigger("commission");
  EXPECT_EQ(filed(), window->document().site().vehicles.back());
  EXPECT_FALSE(window->isWindowModified());
}

// The first supervision stands for a program that died before any site had the key.
TEST_F(NewVehicle, isNotLostWithAKeyThatNoSiteHadWhenTheProgramDied) {
  constexpr VehicleId kFresh{254};
  const wire::Key key{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
  hall.vehicles = {type};
  hall.vehicles.front().id = kFresh;
  hall.vehicles.front().key = wire::kFactoryKey;
  ASSERT_TRUE(floor::saveSite(hall, path().toStdString()));
  ui::ConnectionChoice choice;
  choice.kind = ui::ConnectionChoice::Kind::Serial;
  choice.port = QString::fromStdString(world.port());
  {
    FleetSession died;
    bool taken = false;
    QObject::connect(&died, &ui::FleetLink::eventsArrived, [&](const std::vector<supervisor::Event>& events) {
      for (const auto& event : events) taken = taken || event.pairing == link::PairingEnd::NewKey;
    });
    died.connectTo(choice, floor::SiteMap::build(hall).value());
    ASSERT_TRUE(until([&] {
      const auto picture = died.latest();
      return picture && picture->vehicles.front().contact == supervisor::Contact::Connected;
    }));
    ASSERT_TRUE(died.post(supervisor::Pair{kFresh, key}));
    ASSERT_TRUE(until([&] { return taken; }));
  }
  killWindow();
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  ASSERT_TRUE(window->files().open(path()));
  window->connectTo(choice);
  EXPECT_TRUE(until([&] { return filed().key == key; })) << "saved at once";
  EXPECT_FALSE(window->isWindowModified());
  EXPECT_TRUE(until([&] { return vehicle().contact == supervisor::Contact::Connected; }));
}

TEST_F(NewVehicle, isNotGivenUpByAnEndThatDoesNotAsk) {
  ASSERT_TRUE(window->files().open(path()));
  ASSERT_NO_FATAL_FAILURE(connectToWorld());
  drawRoute({{0.3, 0.3}, {0.3, 1.5}});
  wire::Key key{};
  inDialogue(QStringLiteral("commissionWizard"), [&](QDialog& dialog) {
    WizardHands hands{dynamic_cast<CommissionWizard&>(dialog)};
    describe(hands, "Ant");
    ASSERT_NO_FATAL_FAILURE(pair(hands));
    key = dynamic_cast<CommissionWizard&>(dialog).draft().key;
    window->endUnasked();
    EXPECT_FALSE(dialog.isVisible()) << "the wizard asks before it gives up a paired vehicle; not now";
  });
  trigger("commission");
  EXPECT_FALSE(window->isVisible());
  window.reset();
  answerQuestion("recoverQuestion", "Take them up");
  ASSERT_NO_FATAL_FAILURE(openWindow());
  ASSERT_FALSE(window->document().site().vehicles.empty());
  EXPECT_EQ(window->document().site().vehicles.back().key, key);
}

}  // namespace
}  // namespace tessera::desktop
