// The wizard and the site: what goes in, what is refused, and that giving up leaves no trace.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

#include "tests/ui/commission/fake_link.h"
#include "tests/ui/commission/wizard_hands.h"
#include "ui/commission/commission_wizard.h"
#include "ui/commission/flash_page.h"
#include "ui/commission/vehicle_draft.h"

namespace tessera::ui {
namespace {

class WizardTest : public testing::Test {
protected:
  void SetUp() override {
    floor::VehicleSetup first = VehicleDraft::presets({}).front().setup;
    first.id = VehicleId{1};
    first.name = "AGV 1";
    first.key[0] = 7;
    const auto put = document.edit("begin", [&](floor::Site& s) { s.vehicles.push_back(first); });
    ASSERT_TRUE(put);
    document.undoStack().clear();
  }
  [[nodiscard]] std::size_t vehicles() const { return document.site().vehicles.size(); }

  FakeLink link;
  SiteDocument document;
};

TEST_F(WizardTest, AVehicleEntersTheSiteInOneStepAndLeavesItInOne) {
  CommissionWizard wizard{link, document};
  WizardHands hands{wizard};
  QSignalSpy changed{&wizard, &CommissionWizard::siteChanged};
  hands.next();  // type
  EXPECT_EQ(vehicles(), 1U);
  hands.type("vehicleName", "Forklift");
  hands.next();  // name
  hands.skip();  // firmware
  EXPECT_EQ(wizard.currentId(), CommissionWizard::kKey);
  EXPECT_EQ(vehicles(), 2U);
  EXPECT_EQ(changed.count(), 1);
  EXPECT_EQ(document.undoStack().count(), 1);
  EXPECT_TRUE(document.undoStack().undoText().contains("Forklift"));
  EXPECT_EQ(document.site().vehicles.back().id, VehicleId{2});
  EXPECT_EQ(wizard.vehicle(), VehicleId{2});
  document.undoStack().undo();
  EXPECT_EQ(vehicles(), 1U);
}

TEST_F(WizardTest, GivingUpLeavesTheSiteAsItWas) {
  const floor::Site before = document.site();
  CommissionWizard wizard{link, document};
  WizardHands hands{wizard};
  hands.next();
  hands.next();
  hands.skip();
  ASSERT_EQ(vehicles(), 2U);
  QSignalSpy changed{&wizard, &CommissionWizard::siteChanged};
  QTest::keyClick(&wizard, Qt::Key_Escape);
  EXPECT_FALSE(wizard.isVisible());
  EXPECT_EQ(document.site(), before);
  EXPECT_FALSE(document.isModified());
  EXPECT_EQ(changed.count(), 1);
  EXPECT_EQ(wizard.vehicle(), std::nullopt);
}

TEST_F(WizardTest, GivingUpAfterOtherEditsTakesOnlyTheVehicleOut) {
  CommissionWizard wizard{link, document};
  WizardHands hands{wizard};
  hands.next();
  hands.next();
  hands.skip();
  const auto renamed = document.edit("rename", [](floor::Site& s) { s.name = "Other hall"; });
  ASSERT_TRUE(renamed);
  QTest::keyClick(&wizard, Qt::Key_Escape);
  EXPECT_EQ(vehicles(), 1U);
  EXPECT_EQ(document.site().name, "Other hall");
}

TEST_F(WizardTest, TwoVehiclesAreTwoSteps) {
  for (int i = 0; i < 2; ++i) {
    CommissionWizard wizard{link, document};
    WizardHands hands{wizard};
    hands.next();
    hands.next();
    hands.skip();
    if (i == 1) QTest::keyClick(&wizard, Qt::Key_Escape);
  }
  EXPECT_EQ(vehicles(), 2U) << "giving the second one up leaves the first";
  document.undoStack().redo();
  ASSERT_EQ(vehicles(), 3U);
  document.undoStack().undo();
  EXPECT_EQ(vehicles(), 2U);
}

TEST_F(WizardTest, GivingUpAfterTheSiteWasSavedTakesTheVehicleOutAllTheSame) {
  const floor::Site before = document.site();
  CommissionWizard wizard{link, document};
  WizardHands hands{wizard};
  hands.next();
  hands.next();
  hands.skip();
  document.markSaved();
  hands.back();
  hands.back();
  hands.type("vehicleName", "Late name");
  hands.next();
  hands.next();
  QTest::keyClick(&wizard, Qt::Key_Escape);
  EXPECT_EQ(document.site(), before);
  EXPECT_TRUE(document.isModified());
}

TEST_F(WizardTest, GoingBackAndChangingStaysOneStep) {
  CommissionWizard wizard{link, document};
  WizardHands hands{wizard};
  hands.next();
  hands.next();
  hands.skip();
  hands.back();
  hands.back();
  hands.type("vehicleName", "Late name");
  hands.next();
  hands.next();
  EXPECT_EQ(vehicles(), 2U);
  EXPECT_EQ(document.site().vehicles.back().name, "Late name");
  EXPECT_EQ(document.undoStack().count(), 1);
}

TEST_F(WizardTest, TakenNamesAndAddressesAreRefusedWithASentence) {
  CommissionWizard wizard{link, document};
  WizardHands hands{wizard};
  hands.next();
  hands.type("vehicleName", "AGV 1");
  EXPECT_FALSE(hands.button(QWizard::NextButton).isEnabled());
  hands.type("vehicleName", "AGV 5");
  EXPECT_TRUE(hands.button(QWizard::NextButton).isEnabled());
  hands.at<QSpinBox>("vehicleAddress").setValue(1);
  EXPECT_FALSE(hands.button(QWizard::NextButton).isEnabled());
}

TEST_F(WizardTest, APresetFillsTheMeasuresAndTheyCanBeCorrected) {
  CommissionWizard wizard{link, document};
  WizardHands hands{wizard};
  auto& preset = hands.at<QComboBox>("presetField");
  preset.setFocus();
  QTest::keyClick(&preset, Qt::Key_Down);
  EXPECT_EQ(wizard.draft().readers.size(), 4U);
  auto& wheel = hands.at<QDoubleSpinBox>("wheelField");
  wheel.setValue(0.125);
  EXPECT_DOUBLE_EQ(wizard.draft().wheelDiameter.value(), 0.125);
  hands.click("addReader");
  EXPECT_EQ(wizard.draft().readers.size(), 5U);
  hands.click("removeReader");
  EXPECT_EQ(wizard.draft().readers.size(), 4U);
  EXPECT_EQ(wizard.draft().name, "AGV 2");
}

TEST_F(WizardTest, MeasuresThatContradictThemselvesDoNotPass) {
  CommissionWizard wizard{link, document};
  WizardHands hands{wizard};
  hands.at<QDoubleSpinBox>("trackField").setValue(2.0);
  EXPECT_FALSE(hands.button(QWizard::NextButton).isEnabled());
  hands.at<QDoubleSpinBox>("widthField").setValue(2.5);
  EXPECT_TRUE(hands.button(QWizard::NextButton).isEnabled());
  auto& table = hands.at<QTableWidget>("readerTable");
  table.item(0, 1)->setText("-3");
  EXPECT_FALSE(hands.button(QWizard::NextButton).isEnabled());
  table.item(0, 1)->setText("nonsense");
  EXPECT_EQ(table.item(0, 1)->text().toDouble(), -3.0);
}

TEST_F(WizardTest, AnEditedVehicleKeepsItsPlaceAndItsKey) {
  CommissionWizard wizard{link, document, VehicleId{1}};
  WizardHands hands{wizard};
  hands.at<QDoubleSpinBox>("maxSpeedField").setValue(0.3);
  hands.next();
  hands.next();
  hands.skip();
  ASSERT_EQ(vehicles(), 1U);
  EXPECT_DOUBLE_EQ(document.site().vehicles.front().maxSpeed.value(), 0.3);
  EXPECT_EQ(document.site().vehicles.front().key[0], 7);
  QTest::keyClick(&wizard, Qt::Key_Escape);
  ASSERT_EQ(vehicles(), 1U);
  EXPECT_DOUBLE_EQ(document.site().vehicles.front().maxSpeed.value(), 0.5);
}

TEST_F(WizardTest, CornersAreCutAsTypedAndOneStepTakesItBack) {
  CommissionWizard wizard{link, document, VehicleId{1}};
  WizardHands hands{wizard};
  auto& corner = hands.at<QDoubleSpinBox>("cornerCutField");
  EXPECT_EQ(corner.text(), "0 m: turns on the spot");
  EXPECT_FALSE(corner.toolTip().isEmpty());
  corner.setFocus();
  corner.selectAll();
  QTest::keyClicks(&corner, "0.15");
  QTest::keyClick(&corner, Qt::Key_Up);
  EXPECT_EQ(corner.text(), "0.160 m");
  EXPECT_DOUBLE_EQ(wizard.draft().cornerCut.value(), 0.16);
  corner.selectAll();
  QTest::keyClicks(&corner, "0.9");
  QTest::keyClick(&corner, Qt::Key_Tab);
  EXPECT_LE(wizard.draft().cornerCut, floor::kMostCornerCut) << "more than it may";
  corner.setFocus();
  corner.selectAll();
  QTest::keyClicks(&corner, "0.2");
  hands.next();
  hands.next();
  hands.skip();
  EXPECT_DOUBLE_EQ(document.site().vehicles.front().cornerCut.value(), 0.2);
  EXPECT_EQ(document.undoStack().count(), 1);
  document.undoStack().undo();
  EXPECT_EQ(document.site().vehicles.front().cornerCut, Metres{});
}

TEST_F(WizardTest, EveryStepCanBeSkippedAndTheSummarySaysSo) {
  CommissionWizard wizard{link, document};
  WizardHands hands{wizard};
  hands.next();
  hands.next();
  while (wizard.currentId() != CommissionWizard::kSummary) hands.skip();
  const QString summary = hands.at<QLabel>("summary").text();
  EXPECT_EQ(summary.count("skipped"), static_cast<int>(Commissioning::kSteps));
  QTest::mouseClick(&hands.button(QWizard::FinishButton), Qt::LeftButton);
  EXPECT_EQ(wizard.result(), QDialog::Accepted);
  EXPECT_EQ(vehicles(), 2U);
}

TEST_F(WizardTest, AStepThatIsNeitherDoneNorSkippedHoldsTheWizard) {
  CommissionWizard wizard{link, document};
  WizardHands hands{wizard};
  hands.next();
  hands.next();
  EXPECT_FALSE(hands.button(QWizard::NextButton).isEnabled());
  hands.click("flashDone");
  EXPECT_TRUE(hands.button(QWizard::NextButton).isEnabled());
}

TEST_F(WizardTest, TheFirmwareThatCameWithTheProgramIsWrittenFromWhereItLies) {
  QTemporaryDir installed;
  const QDir root{installed.path()};
  ASSERT_TRUE(root.mkpath("a place/bin") && root.mkpath("a place/share/tessera/firmware"));
  EXPECT_EQ(firmwareImage(root.filePath("a place/bin")), QString{});
  const QString image = root.filePath("a place/share/tessera/firmware/tessera-vehicle.bin");
  QFile file{image};
  ASSERT_TRUE(file.open(QIODevice::WriteOnly) && file.write("x") == 1);
  file.close();
  EXPECT_EQ(firmwareImage(root.filePath("a place/bin")), image);

  CommissionWizard wizard{link, document};
  WizardHands hands{wizard};
  hands.next();
  hands.next();
  auto& page = dynamic_cast<FlashPage&>(*wizard.currentPage());
  EXPECT_TRUE(hands.at<QLineEdit>("flashCommand2").isVisible()) << "made from the sources: an image is made first";
  page.useImage(image);
  EXPECT_EQ(hands.at<QLineEdit>("flashCommand1").text(),
            "openocd -f board/ek-lm3s6965.cfg -c 'program {" + image + "} verify reset exit 0x0'");
  EXPECT_FALSE(hands.at<QLineEdit>("flashCommand2").isVisible());
  EXPECT_EQ(hands.at<QLineEdit>("flashCommand3").text(), "lm4flash \"" + image + "\"");
}

TEST_F(WizardTest, WithoutAConnectionItOffersOne) {
  CommissionWizard wizard{link, document};
  WizardHands hands{wizard};
  QSignalSpy wanted{&wizard, &CommissionWizard::connectRequested};
  hands.next();
  hands.next();
  hands.skip();
  hands.skip();
  EXPECT_EQ(wizard.currentId(), CommissionWizard::kContact);
  hands.click("connectFromWizard");
  EXPECT_EQ(wanted.count(), 1);
  link.show(seenVehicles({1, 2}));
  EXPECT_FALSE(hands.at<QPushButton>("connectFromWizard").isVisible());
}

}  // namespace
}  // namespace tessera::ui
