// Chinese is whole: every text has a translation, every character a shape, and the window shows them.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QFile>
#include <QGlyphRun>
#include <QLabel>
#include <QMessageBox>
#include <QRegularExpression>
#include <QTextLayout>
#include <QTimer>
#include <QXmlStreamReader>

#include "app/desktop/desktop_fixture.h"
#include "app/tessera/site_files.h"

namespace tessera::desktop {
namespace {

QString allTranslations() {
  QFile file{QStringLiteral(TESSERA_I18N "/tessera_zh_CN.ts")};
  EXPECT_TRUE(file.open(QIODevice::ReadOnly));
  QXmlStreamReader xml{&file};
  QString all;
  while (!xml.atEnd()) {
    if (xml.readNextStartElement() && xml.name() == QLatin1String{"translation"})
      all += xml.readElementText(QXmlStreamReader::IncludeChildElements);
  }
  return all;
}

TEST(Chinese, hasAShapeForEveryCharacter) {
  QString characters = allTranslations();
  std::sort(characters.begin(), characters.end());
  characters.erase(std::unique(characters.begin(), characters.end()), characters.end());
  ASSERT_GT(characters.size(), 300);
  QString boxes;
  for (const QChar c : std::as_const(characters)) {
    if (c.isSpace()) continue;
    QTextLayout layout{QString{c}, QApplication::font()};
    layout.beginLayout();
    layout.createLine();
    layout.endLayout();
    for (const QGlyphRun& run : layout.glyphRuns()) {
      if (run.glyphIndexes().contains(0U)) boxes += c;
    }
  }
  EXPECT_TRUE(boxes.isEmpty()) << "drawn as boxes: " << boxes.toStdString();
}

// What may stand in Latin letters: names, units, keys.
bool isForeign(QString text) {
  static const QRegularExpression allowed{QStringLiteral(
      "[Tt]essera|AGV|RFID|UID|E32|TCP|COM|Ctrl|Shift|Alt|Esc|F\\d+|paper|Publication|floor|English|demo|"
      "json|/\\S*|[%#]\\S*")};
  static const QRegularExpression word{QStringLiteral("[A-Za-z]{3,}")};
  text.remove(allowed);
  return text.contains(word);
}

class ChineseWindow : public DesktopTest {};

TEST_F(ChineseWindow, showsNoEnglishWords) {
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  ASSERT_NO_FATAL_FAILURE(startDemo());
  trigger("language_zh_CN");
  pressWhenOffered("runAction", Qt::Key_F5);
  ASSERT_TRUE(until([&] { return vehicle().speed > MetresPerSecond{0.05}; }));
  QTest::qWait(300);  // panels show pictures ten times a second at most; what they show then is looked at
  QStringList foreign;
  for (const auto* label : window->findChildren<QLabel*>())
    if (label->isVisible() && isForeign(label->text())) foreign << label->text();
  for (const auto* button : window->findChildren<QAbstractButton*>())
    if (button->isVisible() && isForeign(button->text())) foreign << button->text();
  for (const auto* action : window->findChildren<QAction*>())
    if (isForeign(action->text())) foreign << action->text();
  EXPECT_TRUE(foreign.isEmpty()) << foreign.join(QStringLiteral(" | ")).toStdString();
}

TEST_F(ChineseWindow, saysWhatIsWrongWithAFile) {
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  trigger("language_zh_CN");
  const QString path = home.filePath("1.tessera.json");
  const auto told = [&] {
    QString text;
    auto* look = new QTimer{window.get()};
    QObject::connect(look, &QTimer::timeout, look, [look, &text] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (box == nullptr) return;
      text = box->text();
      look->deleteLater();
      QTest::keyClick(box, Qt::Key_Return);
    });
    look->start(20);
    EXPECT_FALSE(window->files().open(path));
    return text.remove(path).toStdString();
  };
  const auto toldOf = [&](const QByteArray& contents) {
    QFile file{path};
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(contents);
    file.close();
    return told();
  };
  EXPECT_EQ(told(), "：无法读取：没有这个文件或文件夹。");
  EXPECT_EQ(toldOf("{\"format\": "), "：第 1 行第 12 列：应为 JSON（RFC 8259），实际为其他内容。");
  EXPECT_EQ(toldOf(R"({"format": "tessera-site", "version": 1, "name": ""})"),
            "：/name：应为：1 到 200 个字符的文本；实际为：\"\"。");
  trigger("language_en");
}

}  // namespace
}  // namespace tessera::desktop
