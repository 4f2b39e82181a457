// `tessera-cli radio`: the host's own E32 module: read its parameters, write them, compare them with a site's.
#include <CLI/CLI.hpp>
#include <QEventLoop>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "app/cli/exit_codes.h"
#include "app/cli/output.h"
#include "floor/site_json.h"
#include "host/radio_module.h"
#include "link/radio_advice.h"

namespace tessera::cli {
namespace {

using link::E32Parameters;

struct RadioWords {
  std::string port;
  std::string site;
  std::optional<int> address;
  std::optional<int> channel;
  std::optional<double> airRate;
  std::optional<int> baud;
  std::optional<int> power;
  bool lines = false;
  bool json = false;
};

int dBmOf(const E32Parameters& p) { return link::kE32Powers.at(static_cast<std::size_t>(p.power)); }
double rateOf(const E32Parameters& p) { return link::kE32AirRates.at(static_cast<std::size_t>(p.airRate)); }
const char* nameOf(E32Parameters::Parity parity) {
  return parity == E32Parameters::Parity::None ? "8N1" : parity == E32Parameters::Parity::Odd ? "8O1" : "8E1";
}

nlohmann::json jsonOfParameters(const E32Parameters& p) {
  return {{"address", p.address},
          {"channel", p.channel},
          {"frequency_mhz", 410 + p.channel},
          {"air_rate_bps", rateOf(p)},
          {"uart_baud", p.baud},
          {"uart_format", nameOf(p.parity)},
          {"power_dbm", dBmOf(p)},
          {"fixed_transmission", p.fixedTransmission},
          {"error_correction", p.forwardErrorCorrection}};
}

std::string textOf(const E32Parameters& p) {
  return "channel " + std::to_string(p.channel) + " (" + std::to_string(410 + p.channel) + " MHz), air rate " +
         std::to_string(std::lround(rateOf(p))) + " bit/s, UART " + std::to_string(p.baud) + " baud " +
         nameOf(p.parity) + ", power " + std::to_string(dBmOf(p)) + " dBm, address " + std::to_string(p.address) +
         (p.fixedTransmission ? ", fixed transmission" : "") +
         (p.forwardErrorCorrection ? "" : ", no error correction");
}

/// One conversation with the module. Error: the sentence that it ended with.
Result<E32Parameters> converse(const RadioWords& words, const std::optional<E32Parameters>& toWrite) {
  const auto port = host::PortChoice::parse(QString::fromStdString(words.port), 9600);
  if (!port) return tl::unexpected{port.error()};
  host::RadioModule module{*port, {words.lines}};
  Result<E32Parameters> result = failure("The conversation with the radio module did not end.");
  QEventLoop loop;
  QObject::connect(&module, &host::RadioModule::found, &loop, [&](const E32Parameters& p) {
    result = p;
    loop.quit();
  });
  QObject::connect(&module, &host::RadioModule::failed, &loop, [&](const Sentence& sentence) {
    result = failure(sentence.english());
    loop.quit();
  });
  QObject::connect(&module, &host::RadioModule::notice, &loop,
                   [](const Sentence& sentence) { complain(sentence.english(), 0); });
  // Not before the loop runs: an answer may come at once.
  QMetaObject::invokeMethod(
      &module, [&] { toWrite ? module.write(*toWrite) : module.read(); }, Qt::QueuedConnection);
  loop.exec();
  return result;
}

Result<E32Parameters> ofSite(const std::string& file) {
  const auto site = floor::loadSite(file);
  if (!site) return tl::unexpected{site.error()};
  return host::radioParametersOf(site->radio);
}

int tell(const RadioWords& words, const E32Parameters& p) {
  if (words.json)
    say(jsonOfParameters(p).dump(2));
  else
    say("The radio module has: " + textOf(p) + ".");
  return kDone;
}

int read(const RadioWords& words) {
  const auto module = converse(words, std::nullopt);
  return module ? tell(words, *module) : fail(words.json, module.error().sentence, kNoPort);
}

// What is not named stays as the module has it.
int write(const RadioWords& words) {
  auto wanted = words.site.empty() ? converse(words, std::nullopt) : ofSite(words.site);
  if (!wanted) return fail(words.json, wanted.error().sentence, words.site.empty() ? kNoPort : kBadInput);
  if (words.address) wanted->address = static_cast<std::uint16_t>(*words.address);
  if (words.channel) wanted->channel = *words.channel;
  if (words.airRate) {
    const auto* const rate = std::find(link::kE32AirRates.begin(), link::kE32AirRates.end(), *words.airRate);
    wanted->airRate = static_cast<int>(rate - link::kE32AirRates.begin());
  }
  if (words.baud) wanted->baud = *words.baud;
  if (words.power) {
    const auto* const power = std::find(link::kE32Powers.begin(), link::kE32Powers.end(), *words.power);
    wanted->power = static_cast<int>(power - link::kE32Powers.begin());
  }
  const auto module = converse(words, *wanted);
  return module ? tell(words, *module) : fail(words.json, module.error().sentence, kNoPort);
}

int check(const RadioWords& words) {
  const auto site = ofSite(words.site);
  if (!site) return fail(words.json, site.error().sentence, kBadInput);
  const auto module = converse(words, std::nullopt);
  if (!module) return fail(words.json, module.error().sentence, kNoPort);
  const auto differences = link::differencesFromSite(*module, *site);
  if (words.json) {
    nlohmann::json result{
        {"module", jsonOfParameters(*module)}, {"site", jsonOfParameters(*site)}, {"matches", differences.empty()}};
    result["advice"] = nlohmann::json::array();
    for (const Sentence& sentence : differences) result["advice"].push_back(sentence.english());
    say(result.dump(2));
  } else {
    for (const Sentence& sentence : differences) say(sentence.english());
    if (differences.empty()) say("The radio module matches the site: " + textOf(*module) + ".");
  }
  return differences.empty() ? kDone : kNotFinished;
}

CLI::App* addPart(CLI::App& radio, const char* name, const char* help, const std::shared_ptr<RadioWords>& words,
                  int (*what)(const RadioWords&), Run& run) {
  CLI::App* part = radio.add_subcommand(name, help);
  part->add_option("--port", words->port, "Port of the host's radio: a serial device, or tcp://HOST:PORT")->required();
  part->add_flag("--lines", words->lines, "M0 and M1 hang on RTS and DTR: switch them instead of waiting for jumpers");
  part->add_flag("--json", words->json, "Print the result as JSON");
  part->callback([words, what, &run] { run = [words, what] { return what(*words); }; });
  return part;
}

}  // namespace

void addRadio(CLI::App& app, Run& run) {
  auto* radio = app.add_subcommand(
      "radio", "The host's own radio module; its jumpers M0 and M1 must be set to 1 (on most boards: taken off) first");
  radio->require_subcommand(1);
  auto words = std::make_shared<RadioWords>();
  addPart(*radio, "read", "Tell the module's parameters", words, read, run);
  auto* writing = addPart(*radio, "write", "Write parameters into the module and read them back", words, write, run);
  writing->add_option("--site", words->site,
                      "Take them from this *.tessera.json file (default: as the module has them)");
  writing->add_option("--address", words->address, "All modules of a channel share one; 0x0000 to 0xFFFF, usually 0")
      ->check(CLI::Range(0, 0xFFFF));
  writing->add_option("--channel", words->channel, "410 MHz plus this many MHz")->check(CLI::Range(0, 31));
  writing->add_option("--air-rate", words->airRate, "bit/s on the air")
      ->check(CLI::IsMember{std::vector<double>(link::kE32AirRates.begin(), link::kE32AirRates.end())});
  writing->add_option("--baud", words->baud, "bit/s of the UART")
      ->check(CLI::IsMember{std::vector<int>(link::kE32Bauds.begin(), link::kE32Bauds.end())});
  writing->add_option("--power", words->power, "dBm")
      ->check(CLI::IsMember{std::vector<int>(link::kE32Powers.begin(), link::kE32Powers.end())});
  auto* checking = addPart(*radio, "check", "Compare the module with a site", words, check, run);
  checking->add_option("--site", words->site, "A *.tessera.json file")->required();
}

}  // namespace tessera::cli
