// Pictures of the pages for those who look: written where TESSERA_PICTURES names a folder. In light and dark nothing
// may be cut off.
#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QPalette>
#include <QTest>

#include "tests/ui/connect/look.h"
#include "ui/connect/connect_dialog.h"
#include "ui/connect/radio_dialog.h"
#include "ui/connect/start_page.h"

namespace tessera::ui {
namespace {

class SilentBench : public RadioBench {
public:
  void read() override {}
  void write(const link::E32Parameters& /*parameters*/) override {}
  void cancel() override {}
  void answer(const link::E32Parameters& p) { Q_EMIT found(p); }
};

class ConnectPictures : public testing::TestWithParam<bool> {
protected:
  void SetUp() override { look::setDark(GetParam()); }
  void TearDown() override { look::setDark(false); }
  void picture(QWidget& widget, const char* name) {
    look::take(widget, QStringLiteral("%1-%2").arg(QLatin1String{name}, GetParam() ? "dark" : "light"));
  }
};

TEST_P(ConnectPictures, OfTheStartPage) {
  StartPage page;
  page.resize(page.sizeHint().expandedTo(QSize{900, 640}));
  picture(page, "start-empty");
  const QDateTime when{QDate{2026, 3, 1}, QTime{12, 0}};
  page.setRecent({{"Hall 3", "/home/anna/sites/hall3.tessera.json", when, false},
                  {"The paper's floor", "/home/anna/sites/old.tessera.json", when, true}});
  picture(page, "start");
}

TEST_P(ConnectPictures, OfTheConnectionDialogue) {
  ConnectDialog dialog;
  picture(dialog, "connect-none");
  dialog.setPorts({{"/dev/ttyUSB0", "CP2102 USB to UART Bridge", false}});
  dialog.accept();
  picture(dialog, "connect");
}

TEST_P(ConnectPictures, OfTheRadioDialogue) {
  SilentBench bench;
  RadioDialog dialog{bench, floor::RadioSetup{}};
  dialog.findChild<QPushButton*>("readModule")->click();
  picture(dialog, "radio-reading");
  link::E32Parameters p;
  p.channel = 4;
  bench.answer(p);
  dialog.setAdvice({"Frames arrive damaged: the air rate of a vehicle may be another one."});
  picture(dialog, "radio");
}

INSTANTIATE_TEST_SUITE_P(LightAndDark, ConnectPictures, testing::Bool(),
                         [](const auto& i) { return i.param ? "Dark" : "Light"; });

}  // namespace
}  // namespace tessera::ui
