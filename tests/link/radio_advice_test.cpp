#include "link/radio_advice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tessera::link {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> said(const RadioFindings& findings) {
  std::vector<std::string> all;
  for (const Sentence& s : radioAdvice(findings)) all.push_back(s.english());
  return all;
}

class RadioAdviceTest : public testing::Test {
protected:
  RadioAdviceTest() {
    f.site = e32ParametersFor(23, 19200, 115200).value();
    f.listened = Seconds{30};
  }
  RadioFindings f;
};

TEST_F(RadioAdviceTest, isSilentWhenVehiclesAreHeard) {
  f.lastHeard = Seconds{0.2};
  EXPECT_THAT(said(f), IsEmpty());
  f.module = f.site;
  f.damaged = 100;
  EXPECT_THAT(said(f), IsEmpty()) << "some damage is usual on the air";
}

TEST_F(RadioAdviceTest, isSilentBeforeAVehicleCouldHaveAnswered) {
  f.listened = Seconds{2};
  EXPECT_THAT(said(f), IsEmpty());
}

TEST_F(RadioAdviceTest, namesTheChannelThatDiffers) {
  f.module = f.site;
  f.module->channel = 24;
  EXPECT_THAT(said(f), ElementsAre("The module is on channel 24, the site says 23: write the site's parameters."));
}

TEST_F(RadioAdviceTest, namesEachParameterThatDiffersInTheOrderInWhichItMatters) {
  f.module = f.site;
  f.module->airRate = 2;
  f.module->baud = 9600;
  f.module->parity = E32Parameters::Parity::Even;
  f.module->address = 0x00AB;
  f.module->fixedTransmission = true;
  f.module->forwardErrorCorrection = false;
  EXPECT_THAT(said(f), ElementsAre(HasSubstr("air rate is 2.4 kbit/s, the site says 19.2"),
                                   HasSubstr("at 9600 baud, the site says 115200"), HasSubstr("parity"),
                                   HasSubstr("address 00AB, those of the vehicles have 0000"), HasSubstr("fixed"),
                                   HasSubstr("error correction is off")));
}

TEST_F(RadioAdviceTest, isSilentAboutAMatchWhateverThePower) {
  f.module = f.site;
  f.module->power = 3;
  f.lastHeard = Seconds{1};
  EXPECT_THAT(said(f), IsEmpty());
}

TEST_F(RadioAdviceTest, looksAtTheVehiclesWhereTheModuleMatches) {
  f.module = f.site;
  EXPECT_THAT(said(f), ElementsAre("Nothing is heard of any vehicle though the module matches the site: check the "
                                   "vehicles' channel, their power, the aerials."));
}

TEST_F(RadioAdviceTest, forgetsWhatWasHeardBeforeTheModuleWasSetAnew) {
  f.damaged = f.foreign = 500;
  f.wrongKey = true;
  ASSERT_FALSE(said(f).empty());
  f.moduleChanged(f.site);
  EXPECT_THAT(said(f), IsEmpty());
  f.listened = Seconds{30};
  EXPECT_THAT(said(f), ElementsAre(HasSubstr("Nothing is heard of any vehicle"))) << "noise is no longer the reason";
}

TEST_F(RadioAdviceTest, asksToReadTheModuleFirst) {
  EXPECT_THAT(said(f), ElementsAre(HasSubstr("read the module's parameters")));
}

TEST_F(RadioAdviceTest, takesBytesWithoutFramesForAWrongBaudUntilTheModuleIsKnown) {
  f.damaged = 500;
  EXPECT_THAT(said(f), ElementsAre(HasSubstr("another rate than the site's 115200 baud")));
  f.module = f.site;
  EXPECT_THAT(said(f), ElementsAre(HasSubstr("another sender is on the channel")));
}

TEST_F(RadioAdviceTest, saysSinceWhenNothingIsHeard) {
  f.lastHeard = Seconds{62.4};
  f.module = f.site;
  EXPECT_THAT(said(f), ElementsAre(HasSubstr("No vehicle has been heard for 62 s")));
}

TEST_F(RadioAdviceTest, clearsTheRadioWhereAKeyIsWrongOrStrangersAreHeard) {
  f.wrongKey = true;
  f.foreign = 3;
  EXPECT_THAT(said(f), ElementsAre(HasSubstr("pair it"), HasSubstr("addresses")));
}

}  // namespace
}  // namespace tessera::link
