// What a person reads before an import is made.
#include "ui/exchange/changes_dialog.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QTest>

namespace tessera::ui {
namespace {

exchange::Preview previewOf(int changes) {
  exchange::Preview preview;
  for (int n = 0; n < changes; ++n)
    preview.changes.push_back({sitediff::ChangeKind::Changed,
                               sitediff::Subject::Tile,
                               "T-" + std::to_string(n),
                               phrase("Core", "Tile \"%1\" changes.").with(std::to_string(n)),
                               {}});
  return preview;
}

TEST(Changes, areListedAndTakenByEnter) {
  exchange::Preview preview = previewOf(3);
  preview.notes.push_back(phrase("Core", "A note."));
  ChangesDialog dialog{preview, QStringLiteral("tags.csv")};
  dialog.show();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&dialog));
  EXPECT_TRUE(dialog.windowTitle().contains(QStringLiteral("tags.csv")));
  EXPECT_TRUE(dialog.findChild<QLabel*>("changesHead")->text().contains(QStringLiteral("3")));
  auto* list = dialog.findChild<QListWidget*>("changesList");
  ASSERT_EQ(list->count(), 3);
  EXPECT_TRUE(list->item(2)->text().contains(QStringLiteral("2")));
  EXPECT_EQ(dialog.findChild<QListWidget*>("changesNotes")->item(0)->text(), QStringLiteral("A note."));
  QTest::keyClick(&dialog, Qt::Key_Return);
  EXPECT_EQ(dialog.result(), QDialog::Accepted);
}

TEST(Changes, areTotalledAboveTheirList) {
  exchange::Preview preview = previewOf(1998);
  for (std::size_t n = 0; n < 1997; ++n) preview.changes[n].kind = sitediff::ChangeKind::Added;
  const ChangesDialog dialog{preview, QStringLiteral("tags.csv")};
  const QString head = dialog.findChild<QLabel*>("changesHead")->text();
  EXPECT_TRUE(head.contains(QStringLiteral("%1 new, 1 changed").arg(QLocale().toString(1997)))) << head.toStdString();
}

TEST(Changes, areNotTakenByEscape) {
  ChangesDialog dialog{previewOf(1), QStringLiteral("tags.csv")};
  dialog.show();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&dialog));
  QTest::keyClick(&dialog, Qt::Key_Escape);
  EXPECT_FALSE(dialog.isVisible());
  EXPECT_EQ(dialog.result(), QDialog::Rejected);
}

TEST(Changes, thatAreNoneCanOnlyBeClosed) {
  ChangesDialog dialog{previewOf(0), QStringLiteral("tags.csv")};
  EXPECT_EQ(dialog.findChild<QPushButton*>("changesTake"), nullptr);
  EXPECT_TRUE(dialog.findChild<QLabel*>("changesHead")->text().contains(QStringLiteral("nothing")));
}

TEST(Changes, ofAWholeHallAreNotAllListed) {
  ChangesDialog dialog{previewOf(20'000), QStringLiteral("tags.csv")};
  auto* list = dialog.findChild<QListWidget*>("changesList");
  EXPECT_LT(list->count(), 10'000);
  EXPECT_TRUE(list->item(list->count() - 1)->text().contains(QStringLiteral("15000")))
      << list->item(list->count() - 1)->text().toStdString();
}

}  // namespace
}  // namespace tessera::ui
