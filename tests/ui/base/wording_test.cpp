// What the core says, in the language of the window.
#include "ui/base/wording.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QTranslator>
#include <algorithm>
#include <map>
#include <set>

namespace tessera::ui {
namespace {

// A language that is no language: it knows a few texts and puts others into brackets.
class Gibberish : public QTranslator {
public:
  Gibberish() { QCoreApplication::installTranslator(this); }
  ~Gibberish() override { QCoreApplication::removeTranslator(this); }
  [[nodiscard]] bool isEmpty() const override { return false; }
  [[nodiscard]] QString translate(const char* context, const char* source, const char* /*disambiguation*/,
                                  int /*n*/) const override {
    const auto known = words_.find(source);
    if (known != words_.end() && QByteArray{context} == "Core") return known->second;
    return QByteArray{context} == "Wording" ? QStringLiteral("<%1>").arg(QString::fromUtf8(source)) : QString{};
  }

private:
  std::map<std::string, QString> words_{
      {"%1 waits: an obstacle stands %2 cm before it.", QStringLiteral("%2 厘米：%1 前有障碍物。")},
      {"%1 has restarted (%2); it is called again.", QStringLiteral("%1 已重新启动（%2）。")},
      {"its power was switched on", QStringLiteral("电源接通")},
  };
};

const Sentence kObstacle = phrase("Core", "%1 waits: an obstacle stands %2 cm before it.").with("AGV 1", 23);

TEST(WordingOfSentences, isEnglishWithoutATranslation) {
  EXPECT_EQ(text(kObstacle), "AGV 1 waits: an obstacle stands 23 cm before it.");
  EXPECT_EQ(text(Sentence{}), "");
}

TEST(WordingOfSentences, translatesThePatternAndPutsTheArgumentsWhereThatLanguageWantsThem) {
  const Gibberish language;
  EXPECT_EQ(text(kObstacle), QStringLiteral("23 厘米：AGV 1 前有障碍物。"));
}

TEST(WordingOfSentences, translatesArgumentsThatAreWordsAndLeavesNamesAlone) {
  const Gibberish language;
  const Sentence restarted = phrase("Core", "%1 has restarted (%2); it is called again.")
                                 .with("its power was switched on", phrase("Core", "its power was switched on"));
  EXPECT_EQ(text(restarted), QStringLiteral("its power was switched on 已重新启动（电源接通）。"));
}

TEST(WordingOfSentences, takesAnArgumentThatLooksLikeAPlaceAsItIs) {
  const Gibberish language;
  const Sentence sly = phrase("Core", "%1 waits: an obstacle stands %2 cm before it.").with("%2 100 %", 5);
  EXPECT_EQ(text(sly), QStringLiteral("5 厘米：%2 100 % 前有障碍物。"));
}

TEST(WordingOfSentences, staysEnglishWhereTheTranslationLacks) {
  const Gibberish language;
  EXPECT_EQ(text(phrase("Core", "%1 answers again.").with(QStringLiteral("小车").toStdString())),
            QStringLiteral("小车 answers again."));
}

template <class Enum>
QStringList allOf(int count) {
  QStringList texts;
  for (int i = 0; i < count; ++i) texts.push_back(text(static_cast<Enum>(i)));
  return texts;
}

TEST(WordingOfStates, everyOneHasAWordOfItsOwnThatIsTranslated) {
  for (const bool translated : {false, true}) {
    const auto language = translated ? std::make_unique<Gibberish>() : nullptr;
    for (const QStringList& texts :
         {allOf<supervisor::Contact>(4), allOf<supervisor::Task>(6), allOf<supervisor::PortState>(3),
          allOf<supervisor::CommandStatus>(4), allOf<supervisor::Severity>(3), allOf<wire::VehicleState>(7),
          faultTexts(0x1FFF)}) {
      EXPECT_EQ(std::set<QString>(texts.begin(), texts.end()).size(), static_cast<std::size_t>(texts.size()));
      for (const QString& t : texts) {
        EXPECT_FALSE(t.contains("Unknown")) << t.toStdString();
        EXPECT_EQ(t.startsWith('<'), translated) << t.toStdString();
      }
    }
  }
}

TEST(WordingOfStates, namesEachFaultThatIsSetAndNoOther) {
  EXPECT_TRUE(faultTexts(0).isEmpty());
  EXPECT_EQ(faultTexts(wire::kFaultReader | wire::kFaultMotorStall), (QStringList{"Motor stalled", "Tag reader"}));
  for (int bit = 0; bit < 13; ++bit) EXPECT_EQ(faultTexts(static_cast<std::uint16_t>(1U << bit)).size(), 1) << bit;
}

}  // namespace
}  // namespace tessera::ui
