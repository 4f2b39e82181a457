// What a new site is made of when nothing but Enter is pressed.
#include "ui/connect/new_site_dialog.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QTest>

namespace tessera::ui {
namespace {

TEST(NewSite, hasNoMadeUpUidsUnlessTheyAreAskedFor) {
  NewSiteDialog dialog;
  dialog.show();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&dialog));
  auto* practice = dialog.findChild<QCheckBox*>("practice");
  EXPECT_TRUE(practice->text().contains("made-up UIDs"));
  EXPECT_FALSE(dialog.wish().practice);
  QTest::mouseClick(practice, Qt::LeftButton, {}, QPoint{8, practice->height() / 2});
  EXPECT_TRUE(dialog.wish().practice);
  QTest::keyClick(&dialog, Qt::Key_Return);
  EXPECT_EQ(dialog.result(), QDialog::Accepted);
}

}  // namespace
}  // namespace tessera::ui
