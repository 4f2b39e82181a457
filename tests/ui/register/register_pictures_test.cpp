// Pictures of the panel for those who look: written where TESSERA_PICTURES names a folder.
#include "counter.h"
#include "tests/ui/connect/look.h"

namespace tessera::ui {
namespace {

class RegisterPictures : public Counter, public testing::WithParamInterface<bool> {
protected:
  void SetUp() override {
    look::setDark(GetParam());
    Counter::SetUp();
  }
  void TearDown() override { look::setDark(false); }
  void picture(QWidget& widget, const char* name) {
    look::take(widget, QStringLiteral("%1-%2").arg(QLatin1String{name}, GetParam() ? "dark" : "light"));
  }
};

TEST_P(RegisterPictures, ofThePanelAndTheFloor) {
  picture(panel, "register-setup");
  FloorCanvas canvas;
  canvas.resize(900, 600);
  canvas.openMap(document.map());
  QObject::connect(&document, &SiteDocument::changed, &canvas, [&] { canvas.setMap(document.map()); });
  RegisterTool tool{registrar, panel.page()};
  canvas.setTool(&tool);
  startWithPort();
  bench.say("04A1B2C3\n04A1B2C4\n04A1B2C5\n");
  picture(panel, "register-accepted");
  canvas.finishDrawing();
  picture(canvas, "register-floor");
  bench.say("04A1B2C3\n");
  picture(panel, "register-refused");
  QTest::qWait(500);  // the flash is over
  picture(panel, "register-scan");
  click("scanEnd");
  picture(panel, "register-again");
}

INSTANTIATE_TEST_SUITE_P(InLightAndDark, RegisterPictures, testing::Bool());

}  // namespace
}  // namespace tessera::ui
