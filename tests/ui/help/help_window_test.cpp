// The help by mouse and by key, and the pages themselves.
#include "ui/help/help_window.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QRegularExpression>
#include <QTest>
#include <QToolButton>
#include <QTranslator>

#include "tests/ui/connect/look.h"

namespace tessera::ui {
namespace {

/// Knows one word: which folder holds the pages.
class ChineseFolder : public QTranslator {
public:
  QString translate(const char* /*context*/, const char* text, const char* /*note*/, int /*n*/) const override {
    return QLatin1String{text} == QLatin1String{"en"} ? QStringLiteral("zh_CN") : QString{};
  }
  [[nodiscard]] bool isEmpty() const override { return false; }
};

class HelpWindowTest : public testing::Test {
protected:
  void SetUp() override {
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  }
  QListWidget& contents() { return *window.findChild<QListWidget*>("helpContents"); }
  QTextBrowser& page() { return *window.findChild<QTextBrowser*>("helpPage"); }
  HelpWindow window;
};

TEST_F(HelpWindowTest, ShowsATopicAndMarksItInTheContents) {
  EXPECT_EQ(contents().count(), static_cast<int>(HelpPages::topics().size()));
  window.showTopic("routes");
  EXPECT_EQ(window.topic(), "routes");
  EXPECT_TRUE(page().toPlainText().startsWith("Routes"));
  EXPECT_EQ(contents().currentItem()->text(), "Routes");
  window.showTopic("nonsense");
  EXPECT_EQ(window.topic(), "start");
}

TEST_F(HelpWindowTest, GoesBackAndForward) {
  window.showTopic("radio");
  window.showTopic("charts");
  QTest::keyClick(&window, Qt::Key_Left, Qt::AltModifier);
  EXPECT_EQ(window.topic(), "radio");
  QTest::keyClick(&window, Qt::Key_Right, Qt::AltModifier);
  EXPECT_EQ(window.topic(), "charts");
}

TEST_F(HelpWindowTest, AClickInTheContentsOpensThePage) {
  const QRect row = contents().visualItemRect(contents().item(2));
  QTest::mouseClick(contents().viewport(), Qt::LeftButton, {}, row.center());
  EXPECT_EQ(window.topic(), HelpPages::topics()[2]);
}

TEST_F(HelpWindowTest, SearchLeavesThePagesThatHoldEveryWord) {
  QTest::keyClick(&window, Qt::Key_F, Qt::ControlModifier);
  auto* search = window.findChild<QLineEdit*>("helpSearch");
  EXPECT_TRUE(search->hasFocus());
  QTest::keyClicks(search, "dialout group");
  EXPECT_EQ(contents().count(), 1);
  QTest::keyClick(search, Qt::Key_Return);
  EXPECT_EQ(window.topic(), "connecting");
  EXPECT_FALSE(page().extraSelections().isEmpty());
  QTest::keyClicks(search, " unheardof");
  EXPECT_EQ(contents().count(), 0);
}

TEST_F(HelpWindowTest, EscapeClosesIt) {
  QTest::keyClick(&page(), Qt::Key_Escape);
  EXPECT_FALSE(window.isVisible());
}

TEST_F(HelpWindowTest, ChangesItsLanguageWhileItIsOpen) {
  window.showTopic("routes");
  ChineseFolder chinese;
  QCoreApplication::installTranslator(&chinese);
  EXPECT_TRUE(QTest::qWaitFor([&] { return page().toPlainText().startsWith(QString::fromUtf8("运行路径")); }));
  EXPECT_EQ(window.topic(), "routes");
  QCoreApplication::removeTranslator(&chinese);
  EXPECT_TRUE(QTest::qWaitFor([&] { return page().toPlainText().startsWith("Routes"); }));
}

TEST_F(HelpWindowTest, HasPicturesInLightAndDark) {
  for (const bool dark : {false, true}) {
    look::setDark(dark);
    window.showTopic("connecting");
    look::take(window, dark ? "help-dark" : "help-light");
  }
  look::setDark(false);
}

TEST(HelpTopic, IsThatOfTheNearestParent) {
  QWidget view;
  auto* inner = new QWidget{&view};
  auto* leaf = new QWidget{inner};
  EXPECT_EQ(helpTopicOf(leaf), "start");
  view.setProperty("helpTopic", "floor");
  EXPECT_EQ(helpTopicOf(leaf), "floor");
  inner->setProperty("helpTopic", "charts");
  EXPECT_EQ(helpTopicOf(leaf), "charts");
  EXPECT_EQ(helpTopicOf(nullptr), "start");
}

TEST(HelpPagesInBothLanguages, AreTheSameWithTheSameLinksAndKeys) {
  const auto read = [](const QString& folder, const QString& topic) {
    QFile file{QStringLiteral(":/help/%1/%2.md").arg(folder, topic)};
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << folder.toStdString() << "/" << topic.toStdString();
    return QString::fromUtf8(file.readAll());
  };
  const auto all = [](const QString& text, const char* pattern) {
    QStringList found;
    for (auto it = QRegularExpression{QLatin1String{pattern}}.globalMatch(text); it.hasNext();)
      found << it.next().captured(0);
    found.sort();
    return found;
  };
  for (const QString& topic : HelpPages::topics()) {
    const QString english = read("en", topic);
    const QString chinese = read("zh_CN", topic);
    EXPECT_TRUE(english.startsWith("# "));
    EXPECT_TRUE(chinese.startsWith("# "));
    for (const char* pattern : {"\\]\\([a-z_]+\\.md\\)", "\\bF\\d+\\b", "Ctrl\\+[A-Z]\\b"})
      EXPECT_EQ(all(english, pattern), all(chinese, pattern)) << topic.toStdString();
    for (const QString& link : all(english, "\\]\\([a-z_]+\\.md\\)")) {
      const QString target = link.mid(2, link.size() - 6);
      EXPECT_NE(std::find(HelpPages::topics().begin(), HelpPages::topics().end(), target), HelpPages::topics().end())
          << link.toStdString();
    }
    EXPECT_EQ(english.count('\n'), chinese.count('\n')) << topic.toStdString();
  }
  EXPECT_EQ(QDir{":/help/en"}.entryList(), QDir{":/help/zh_CN"}.entryList());
}

}  // namespace
}  // namespace tessera::ui
