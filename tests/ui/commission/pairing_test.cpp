// Giving a vehicle its key: the site follows the vehicle, and no key is lost on the way.
#include "wire/pairing.h"

#include <gtest/gtest.h>

#include <QMessageBox>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>

#include "tests/ui/commission/fake_link.h"
#include "tests/ui/commission/wizard_hands.h"
#include "ui/base/notice.h"
#include "ui/commission/commission_wizard.h"
#include "wire/parameters.h"

namespace tessera::ui {
namespace {

using supervisor::Ask;
using supervisor::Pair;

class PairingTest : public testing::Test {
protected:
  void SetUp() override {
    fleet.show(seenVehicles({}));  // supervision runs and hears nobody
    hands.next();
    hands.next();
    hands.skip();
    ASSERT_EQ(wizard.currentId(), CommissionWizard::kKey);
    first = entry();
  }
  [[nodiscard]] const floor::VehicleSetup& entry() const { return document.site().vehicles.back(); }
  void pairingEnds(std::uint8_t vehicle, link::PairingEnd how, Seconds time = Seconds{11.0}) {
    supervisor::Event event;
    event.time = time;
    event.kind = supervisor::EventKind::Paired;
    event.vehicle = VehicleId{vehicle};
    event.sentence = "so it ended";
    event.pairing = how;
    fleet.tell(event);
  }
  Notice::Tone tone() { return hands.at<Notice>("keyResult").tone(); }
  void pressPair() { hands.click("pairVehicle"); }

  FakeLink fleet;
  SiteDocument document;
  CommissionWizard wizard{fleet, document};
  WizardHands hands{wizard};
  floor::VehicleSetup first;
};

TEST_F(PairingTest, AVehicleInContactGetsANewKeyAndTheSiteHasIt) {
  fleet.show(seenVehicles({1}));
  pressPair();
  const wire::Key fresh = fleet.last<Pair>().newKey;
  EXPECT_EQ(fleet.last<Pair>().vehicle, VehicleId{1});
  EXPECT_NE(fresh, first.key);
  EXPECT_EQ(entry().key, first.key);
  pairingEnds(1, link::PairingEnd::NewKey);
  EXPECT_EQ(entry().key, fresh);
  EXPECT_EQ(entry().id, VehicleId{1});
  EXPECT_EQ(tone(), Notice::Tone::Good);
  EXPECT_EQ(document.undoStack().count(), 1);
}

TEST_F(PairingTest, AnEarlierPairingThatEndsLateIsNotTakenForThisOne) {
  fleet.show(seenVehicles({1}));
  pressPair();
  pairingEnds(1, link::PairingEnd::NewKey, fleet.picture->time);
  EXPECT_EQ(entry().key, first.key);
  pairingEnds(1, link::PairingEnd::NewKey);
  EXPECT_EQ(entry().key, fleet.last<Pair>().newKey);
}

TEST_F(PairingTest, AFreshVehicleGetsItsKeyAndThenItsAddress) {
  pressPair();
  EXPECT_EQ(entry().id, VehicleId{254});
  EXPECT_EQ(entry().key, wire::kFactoryKey);
  fleet.show(seenVehicles({254}));
  ASSERT_EQ(fleet.count<Pair>(), 1U);
  const wire::Key fresh = fleet.last<Pair>().newKey;
  pairingEnds(254, link::PairingEnd::NewKey);
  EXPECT_EQ(entry().id, VehicleId{254});
  EXPECT_EQ(entry().key, fresh);
  fleet.show(seenVehicles({254}));
  EXPECT_EQ(fleet.last<Ask>().request.parameter, static_cast<std::uint8_t>(wire::Parameter::Address));
  EXPECT_EQ(fleet.last<Ask>().request.value, 1);
  fleet.answer(wire::Outcome::Done, 1);
  EXPECT_EQ(fleet.last<Ask>().request.type, wire::MessageType::Do);
  fleet.answer(wire::Outcome::Started, 0);
  EXPECT_EQ(entry().id, VehicleId{1});
  EXPECT_EQ(entry().key, fresh);
  EXPECT_EQ(document.site().vehicles.size(), 1U);
  fleet.show(seenVehicles({1}));
  EXPECT_TRUE(hands.button(QWizard::NextButton).isEnabled());
}

TEST_F(PairingTest, ARefusalLeavesTheSiteAsItWas) {
  pressPair();
  fleet.show(seenVehicles({254}));
  pairingEnds(254, link::PairingEnd::Busy);
  EXPECT_EQ(entry(), first);
  EXPECT_EQ(tone(), Notice::Tone::Error);
  EXPECT_FALSE(hands.button(QWizard::NextButton).isEnabled());
}

TEST_F(PairingTest, ADoubtIsWaitedForAndNeverHidden) {
  fleet.show(seenVehicles({1}));
  pressPair();
  pairingEnds(1, link::PairingEnd::Unknown);
  EXPECT_EQ(entry(), first);
  EXPECT_EQ(tone(), Notice::Tone::Info);
  pressPair();  // gives up
  EXPECT_EQ(tone(), Notice::Tone::Warning);
  EXPECT_GT(hands.at<Notice>("keyResult").text().size(), 40);
}

TEST_F(PairingTest, LeavingThePageGivesItUp) {
  pressPair();
  EXPECT_EQ(entry().id, VehicleId{254});
  hands.back();
  EXPECT_EQ(entry(), first);
}

TEST_F(PairingTest, GivingTheWizardUpAfterPairingIsAskedFor) {
  fleet.show(seenVehicles({1}));
  pressPair();
  pairingEnds(1, link::PairingEnd::NewKey);
  const auto answerWith = [&](const char* role) {
    QTimer::singleShot(0, &wizard, [role] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      ASSERT_NE(box, nullptr);
      for (QAbstractButton* b : box->buttons())
        if (b->text().contains(QLatin1String{role})) QTest::mouseClick(b, Qt::LeftButton);
    });
    QTest::keyClick(&wizard, Qt::Key_Escape);
  };
  answerWith("Go on");
  EXPECT_TRUE(wizard.isVisible());
  EXPECT_EQ(document.site().vehicles.size(), 1U);
  answerWith("Give up");
  EXPECT_FALSE(wizard.isVisible());
  EXPECT_TRUE(document.site().vehicles.empty());
}

TEST_F(PairingTest, SaysUntilItIsSavedThatNoFileHasTheKey) {
  fleet.show(seenVehicles({1}));
  EXPECT_FALSE(hands.at<QPushButton>("saveKey").isVisible());
  pressPair();
  pairingEnds(1, link::PairingEnd::NewKey);
  EXPECT_TRUE(hands.at<QPushButton>("saveKey").isVisible());
  QSignalSpy asked{&wizard, &CommissionWizard::saveRequested};
  hands.click("saveKey");
  EXPECT_EQ(asked.count(), 1);
  document.markSaved();
  EXPECT_FALSE(hands.at<QPushButton>("saveKey").isVisible());
  EXPECT_TRUE(hands.at<Notice>("keyUnsaved").text().isEmpty());
}

TEST_F(PairingTest, GivingUpTheChangesToAVehicleDoesNotBringItsOldKeyBack) {
  document.undoStack().clear();  // as if it had been set up long ago
  wizard.hide();
  CommissionWizard again{fleet, document, VehicleId{1}};
  WizardHands other{again};
  other.next();
  other.type("vehicleName", "Ant");
  other.next();
  other.skip();
  QTest::mouseClick(&other.at<QRadioButton>("pairKind"), Qt::LeftButton, {}, QPoint{8, 8});
  fleet.show(seenVehicles({1}));
  other.click("pairVehicle");
  const wire::Key fresh = fleet.last<Pair>().newKey;
  pairingEnds(1, link::PairingEnd::NewKey);
  ASSERT_EQ(entry().name, "Ant");
  QTest::keyClick(&again, Qt::Key_Escape);
  EXPECT_FALSE(again.isVisible());
  EXPECT_EQ(entry().name, first.name);
  EXPECT_EQ(entry().key, fresh) << "the vehicle has it, whatever else was given up";
  EXPECT_EQ(document.site().vehicles.size(), 1U);
}

}  // namespace
}  // namespace tessera::ui
