// Pictures of every page for those who look: written where TESSERA_PICTURES names a folder.
#include <gtest/gtest.h>

#include "tests/ui/commission/fake_link.h"
#include "tests/ui/commission/wizard_hands.h"
#include "tests/ui/connect/look.h"
#include "ui/commission/commission_wizard.h"
#include "ui/commission/jog_dialog.h"

namespace tessera::ui {
namespace {

class CommissionPictures : public testing::TestWithParam<bool> {
protected:
  void SetUp() override { look::setDark(GetParam()); }
  void TearDown() override { look::setDark(false); }
  [[nodiscard]] QString name(const QString& what) const {
    return QStringLiteral("%1-%2").arg(what, GetParam() ? QStringLiteral("dark") : QStringLiteral("light"));
  }
  FakeLink link;
  SiteDocument document;
};

TEST_P(CommissionPictures, OfEveryPageWithAVehicle) {
  link.show(seenVehicles({1}));
  CommissionWizard wizard{link, document};
  WizardHands hands{wizard};
  for (int page = 0; page < CommissionWizard::kPages; ++page) {
    link.show(seenVehicles({1}));
    look::take(wizard, name(QStringLiteral("wizard-%1").arg(page, 2, 10, QLatin1Char('0'))));
    if (page < CommissionWizard::kFirmware)
      hands.next();
    else if (page < CommissionWizard::kSummary)
      hands.skip();
  }
}

TEST_P(CommissionPictures, OfAPageWithoutAConnection) {
  CommissionWizard wizard{link, document};
  WizardHands hands{wizard};
  hands.next();
  hands.next();
  hands.skip();
  look::take(wizard, name("wizard-alone"));
}

TEST_P(CommissionPictures, OfAKeyThatNoFileHasYet) {
  link.show(seenVehicles({1}));
  CommissionWizard wizard{link, document};
  WizardHands hands{wizard};
  hands.next();
  hands.next();
  hands.skip();
  hands.click("pairVehicle");
  supervisor::Event event;
  event.time = Seconds{11.0};  // after what the picture shows
  event.kind = supervisor::EventKind::Paired;
  event.vehicle = VehicleId{1};
  event.pairing = link::PairingEnd::NewKey;
  link.tell(event);
  look::take(wizard, name("wizard-unsaved-key"));
}

TEST_P(CommissionPictures, OfDrivingByHand) {
  Selection selection;
  JogDialog dialog{link, selection};
  look::take(dialog, name("jog-alone"));
  link.show(seenVehicles({1}));
  selection.setVehicle(VehicleId{1});
  look::take(dialog, name("jog"));
}

INSTANTIATE_TEST_SUITE_P(LightAndDark, CommissionPictures, testing::Bool(),
                         [](const auto& i) { return i.param ? "Dark" : "Light"; });

}  // namespace
}  // namespace tessera::ui
