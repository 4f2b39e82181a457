// What the program says of itself.
#include "ui/help/about_dialog.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QTest>

#include "tests/ui/connect/look.h"
#include "ui/help/third_parties.h"

namespace tessera::ui {
namespace {

TEST(AboutDialog, NamesTheRunningQtAndTheWholeLicence) {
  AboutDialog dialog{nullptr, "3.40.1"};
  EXPECT_TRUE(dialog.report().contains(QLatin1String{qVersion()}));
  EXPECT_TRUE(dialog.report().contains("SQLite 3.40.1"));
  const QString licence = dialog.findChild<QPlainTextEdit*>("licenceText")->toPlainText();
  EXPECT_TRUE(licence.contains("GNU GENERAL PUBLIC LICENSE"));
  EXPECT_TRUE(licence.contains("How to Apply These Terms"));
}

TEST(AboutDialog, CopiesTheVersions) {
  AboutDialog dialog;
  dialog.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
  QTest::mouseClick(dialog.findChild<QPushButton*>("copyAbout"), Qt::LeftButton);
  EXPECT_EQ(QApplication::clipboard()->text(), dialog.report());
}

TEST(AboutDialog, EveryPartHasALicence) {
  for (const ThirdParty& part : ThirdParties::all({})) {
    EXPECT_FALSE(part.licence.isEmpty()) << part.name.toStdString();
    EXPECT_FALSE(part.use.isEmpty()) << part.name.toStdString();
  }
  EXPECT_FALSE(ThirdParties::programVersion().isEmpty());
}

TEST(AboutDialog, HasAPictureInLightAndDark) {
  for (const bool dark : {false, true}) {
    look::setDark(dark);
    AboutDialog dialog;
    look::take(dialog, dark ? "about-dark" : "about-light");
  }
  look::setDark(false);
}

}  // namespace
}  // namespace tessera::ui
