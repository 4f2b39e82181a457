// main() of tests that open windows: a QApplication on the offscreen platform, the same font and style everywhere.
#include <gtest/gtest.h>

#include <QApplication>
#include <QStandardPaths>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (GTEST_FLAG_GET(list_tests)) return RUN_ALL_TESTS();
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  QStandardPaths::setTestModeEnabled(true);  // settings and data of the person who runs the tests stay untouched
  QApplication application{argc, argv};
  QApplication::setOrganizationName("tessera-test");
  QApplication::setApplicationName("tessera-test");
  QApplication::setStyle("Fusion");
  return RUN_ALL_TESTS();
}
