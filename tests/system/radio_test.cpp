// The host's own radio module over a real pseudo terminal: its parameters read and written while its jumpers are set
// for that, and what becomes of the vehicles when it is on another channel than they are.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <nlohmann/json.hpp>

#include "app/cli/exit_codes.h"
#include "host/radio_module.h"
#include "system/supervision.h"
#include "system/world.h"

namespace tessera::system_test {
namespace {

using link::E32Parameters;

const std::string kPaper = TESSERA_SITES "/paper.tessera.json";
const E32Parameters kSite = link::e32ParametersFor(23, 19200, 115200).value();

class RadioModuleTest : public testing::Test {
protected:
  RadioModuleTest() : world{folder, kPaper, {"--kind", "native"}} {}

  void SetUp() override { ASSERT_NE(world.port(), "") << world.program().errors(); }
  host::PortChoice port() const { return host::PortChoice::parse(QString::fromStdString(world.port()), 9600).value(); }
  /// What the module holds after this; nullopt: it failed, and says why.
  std::optional<E32Parameters> converse(const std::function<void(host::RadioModule&)>& work,
                                        host::RadioModule::Options options = {}) {
    host::RadioModule module{port(), options};
    std::optional<E32Parameters> result;
    bool over = false;
    QObject::connect(&module, &host::RadioModule::found, [&](const E32Parameters& p) {
      result = p;
      over = true;
    });
    QObject::connect(&module, &host::RadioModule::failed, [&](const Sentence& sentence) {
      said = sentence.english();
      over = true;
    });
    QObject::connect(&module, &host::RadioModule::notice, [&](const Sentence& s) { noticed = s.english(); });
    work(module);
    const QDeadlineTimer end{kPatienceMs};
    while (!over && !end.hasExpired()) QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
    return result;
  }
  std::optional<E32Parameters> read() {
    return converse([](host::RadioModule& m) { m.read(); });
  }
  std::optional<E32Parameters> write(const E32Parameters& p) {
    return converse([&](host::RadioModule& m) { m.write(p); });
  }
  bool aVehicleAnswers() {
    Supervision supervision{kPaper, world.port()};
    return supervision.until([&] { return supervision.connected(); });
  }

  QTemporaryDir folder;
  World world;
  std::string said;
  std::string noticed;
};

TEST_F(RadioModuleTest, anotherChannelMakesTheVehiclesSilentAndTheSitesBringsThemBack) {
  ASSERT_TRUE(aVehicleAnswers());
  ASSERT_TRUE(world.order("jumpers 1 1")) << world.answer();
  ASSERT_EQ(read(), kSite) << said;
  E32Parameters moved = kSite;
  moved.channel = 24;
  ASSERT_EQ(write(moved), moved) << said;
  ASSERT_TRUE(world.order("jumpers 0 0")) << world.answer();
  {
    Supervision supervision{kPaper, world.port()};
    const Seconds begin = host::steadyNow();
    ASSERT_TRUE(supervision.until([&] { return host::steadyNow() - begin > Seconds{5}; }));
    EXPECT_EQ(supervision.view().contact, supervisor::Contact::Calling) << "host and vehicle are deaf to each other";
    EXPECT_EQ(supervision.view().link.reports, 0U);
  }
  ASSERT_TRUE(world.order("jumpers 1 1"));
  ASSERT_EQ(write(kSite), kSite) << said;
  ASSERT_TRUE(world.order("jumpers 0 0"));
  EXPECT_TRUE(aVehicleAnswers());
}

TEST_F(RadioModuleTest, saysToSetTheJumpersWhereTheModuleIsInNormalMode) {
  EXPECT_EQ(read(), std::nullopt);
  EXPECT_NE(said.find("jumpers"), std::string::npos) << said;
  ASSERT_TRUE(world.order("jumpers 1 1"));
  EXPECT_TRUE(read()) << said << " The port must have been given free again.";
}

TEST_F(RadioModuleTest, saysThatThePortIsGone) {
  ASSERT_TRUE(world.order("pull"));
  EXPECT_EQ(read(), std::nullopt);
  EXPECT_NE(said.find("The port " + world.port() + " cannot be used: there is no such device."), std::string::npos)
      << said;
}

TEST_F(RadioModuleTest, tellsThatTheLinesCannotBeSwitchedAndGoesOnAllTheSame) {
  ASSERT_TRUE(world.order("jumpers 1 1"));
  const auto found = converse([](host::RadioModule& m) { m.read(); }, {.switchLines = true});
  EXPECT_EQ(found, kSite) << said;
  EXPECT_NE(noticed.find("RTS and DTR"), std::string::npos) << "a pseudo terminal has none";
}

TEST_F(RadioModuleTest, isSilentWhenItWasCancelled) {
  host::RadioModule module{port()};
  int told = 0;
  QObject::connect(&module, &host::RadioModule::found, [&] { ++told; });
  QObject::connect(&module, &host::RadioModule::failed, [&] { ++told; });
  module.read();
  EXPECT_TRUE(module.busy());
  module.cancel();
  EXPECT_FALSE(module.busy());
  const QDeadlineTimer end{3000};
  while (!end.hasExpired()) QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
  EXPECT_EQ(told, 0);
}

TEST_F(RadioModuleTest, refusesParametersThatNoModuleHas) {
  E32Parameters wrong = kSite;
  wrong.channel = 77;
  EXPECT_EQ(write(wrong), std::nullopt);
  EXPECT_NE(said.find("no channel 77"), std::string::npos) << said;
}

TEST_F(RadioModuleTest, isReadWrittenAndCheckedOnTheCommandLine) {
  const auto run = [&](std::vector<std::string> words, int code) {
    words.insert(words.begin(), "radio");
    words.insert(words.end(), {"--port", world.port(), "--json"});
    Program cli{TESSERA_CLI, words};
    EXPECT_EQ(cli.exitCode(), code) << cli.errors();
    said = cli.errors();
    return nlohmann::json::parse(cli.output(), nullptr, false);
  };
  run({"read"}, cli::kNoPort);
  EXPECT_NE(said.find("jumpers"), std::string::npos) << said;
  ASSERT_TRUE(world.order("jumpers 1 1"));
  EXPECT_EQ(run({"read"}, cli::kDone)["channel"], 23);
  EXPECT_EQ(run({"check", "--site", kPaper}, cli::kDone)["matches"], true);
  const auto written = run({"write", "--channel", "24", "--air-rate", "9600"}, cli::kDone);
  EXPECT_EQ(written["channel"], 24);
  EXPECT_EQ(written["air_rate_bps"], 9600.0);
  EXPECT_EQ(written["uart_baud"], 115200) << "what is not named stays";
  const auto differs = run({"check", "--site", kPaper}, cli::kNotFinished);
  EXPECT_EQ(differs["advice"][0], "The module is on channel 24, the site says 23: write the site's parameters.");
  const auto addressed = run({"write", "--address", "0x12ab"}, cli::kDone);
  EXPECT_EQ(addressed["address"], 0x12AB);
  EXPECT_EQ(addressed["channel"], 24) << "what is not named stays";
  EXPECT_EQ(run({"write", "--address", "65536"}, cli::kUsage).is_discarded(), true) << "no module has it";
  const auto asTheSite = run({"write", "--site", kPaper}, cli::kDone);
  EXPECT_EQ(asTheSite["channel"], 23);
  EXPECT_EQ(asTheSite["address"], kSite.address);
}

}  // namespace
}  // namespace tessera::system_test
