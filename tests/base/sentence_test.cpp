#include "base/sentence.h"

#include <gtest/gtest.h>

#include <sstream>

namespace tessera {
namespace {

TEST(Sentence, readsAsEnglishAndRemembersHowItWasMade) {
  const Sentence waits = phrase("Core", "%1 waits: an obstacle stands %2 cm before it.").with("AGV 1", 23);
  EXPECT_EQ(waits, "AGV 1 waits: an obstacle stands 23 cm before it.");
  ASSERT_NE(waits.pattern(), nullptr);
  EXPECT_STREQ(waits.pattern()->context(), "Core");
  EXPECT_STREQ(waits.pattern()->english(), "%1 waits: an obstacle stands %2 cm before it.");
  ASSERT_EQ(waits.arguments().size(), 2U);
  EXPECT_EQ(waits.arguments()[0], "AGV 1");
  EXPECT_EQ(waits.arguments()[0].pattern(), nullptr) << "a name is nobody's to translate";
}

TEST(Sentence, takesSentencesAndPatternsAsArguments) {
  const Sentence cause = phrase("Core", "its watchdog ended a hang after %1 s").with(std::string{"0.5"});
  const Sentence whole =
      phrase("Core", "%1 has restarted (%2); %3.").with("AGV 1", cause, phrase("Core", "it is called"));
  EXPECT_EQ(whole, "AGV 1 has restarted (its watchdog ended a hang after 0.5 s); it is called.");
  EXPECT_NE(whole.arguments()[1].pattern(), nullptr);
  EXPECT_NE(whole.arguments()[2].pattern(), nullptr);
}

TEST(Sentence, argumentsThatLookLikePlacesAreLeftAlone) {
  EXPECT_EQ(phrase("Core", "%1 and %2").with("%2", "%1"), "%2 and %1");
  EXPECT_EQ(phrase("Core", "%2 before %1, 100 %, %").with("a", "b"), "b before a, 100 %, %");
  EXPECT_EQ(phrase("Core", "%1 and %2").with("a"), "a and %2") << "a slip stays to be seen";
  EXPECT_EQ(phrase("Core", "%1%1%0").with("a"), "aa%0");
}

TEST(Sentence, canBeKeptAsItsPartsAndRestored) {
  Sentence restored;
  {
    const std::string pattern = "The port %1 is lost: the other end of the cable is gone.";
    restored = Sentence::restored(pattern, {"COM3"});
  }
  EXPECT_EQ(restored, "The port COM3 is lost: the other end of the cable is gone.");
  ASSERT_NE(restored.pattern(), nullptr);
  EXPECT_STREQ(restored.pattern()->context(), "Core");
  EXPECT_STREQ(restored.pattern()->english(), "The port %1 is lost: the other end of the cable is gone.");
}

TEST(Sentence, isEmptyUntilItSaysSomething) {
  EXPECT_TRUE(Sentence{}.empty());
  EXPECT_TRUE(Sentence{""}.empty());
  EXPECT_EQ(Sentence{}.pattern(), nullptr);
  EXPECT_TRUE(Sentence{}.arguments().empty());
  EXPECT_FALSE(Sentence{phrase("Core", "Word.")}.empty());
}

TEST(Sentence, isEqualToWhatReadsTheSame) {
  const Sentence made = phrase("Core", "The port %1 is open.").with("COM3");
  EXPECT_EQ(made, Sentence{"The port COM3 is open."});
  EXPECT_EQ(made, std::string{"The port COM3 is open."});
  EXPECT_NE(made, Sentence{"The port COM4 is open."});
  const std::string& plain = made;
  EXPECT_EQ(plain, "The port COM3 is open.");
  std::ostringstream out;
  out << made;
  EXPECT_EQ(out.str(), plain);
}

}  // namespace
}  // namespace tessera
