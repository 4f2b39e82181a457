#include "link/radio_advice.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace tessera::link {
namespace {

constexpr Seconds kLately{5.0};      // a vehicle that answers is heard several times in this time
constexpr Seconds kEnough{10.0};     // by then every vehicle has been called several times
constexpr std::uint32_t kSome = 20;  // damaged bytes that are more than a chance

std::string kilobits(int airRate) {
  const auto tenths = static_cast<int>(kE32AirRates[static_cast<std::size_t>(std::clamp(airRate, 0, 5))] / 100);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

std::string hex(std::uint16_t address) {
  constexpr const char* digits = "0123456789ABCDEF";
  std::string text;
  for (unsigned shift = 16; shift > 0; shift -= 4) text += digits[address >> (shift - 4) & 0xFU];
  return text;
}

void adviseOnSilence(const RadioFindings& f, bool matches, std::vector<Sentence>& advice) {
  const bool noise = f.damaged >= kSome;
  if (f.lastHeard) {
    advice.push_back(
        phrase(
            "Core",
            "No vehicle has been heard for %1 s, though some were before: check the vehicles' power, the aerials, the "
            "distance, and that the module's jumpers M0 and M1 are in normal mode (both 0).")
            .with(static_cast<long>(std::lround(f.lastHeard->value()))));
  } else if (noise && !matches) {
    advice.push_back(
        phrase(
            "Core",
            "Bytes come from the module, but no whole frame: its UART may run at another rate than the site's %1 baud. "
            "Read its parameters.")
            .with(f.site.baud));
  } else if (noise) {
    advice.push_back(phrase("Core",
                            "Bytes come from the module, but no whole frame: another sender is on the channel, or the "
                            "vehicles' air rate differs. Switch the other one off, or choose another channel."));
  } else if (matches) {
    advice.push_back(phrase("Core",
                            "Nothing is heard of any vehicle though the module matches the site: check the vehicles' "
                            "channel, their power, the aerials."));
  } else {
    advice.push_back(
        phrase("Core",
               "Nothing is heard of any vehicle: read the module's parameters to see whether they match the "
               "site, then put its jumpers M0 and M1 back to normal mode (both 0)."));
  }
}

}  // namespace

std::vector<Sentence> differencesFromSite(const E32Parameters& module, const E32Parameters& site) {
  std::vector<Sentence> found;
  if (module.channel != site.channel)
    found.push_back(phrase("Core", "The module is on channel %1, the site says %2: write the site's parameters.")
                        .with(module.channel, site.channel));
  if (module.airRate != site.airRate)
    found.push_back(phrase("Core", "The module's air rate is %1 kbit/s, the site says %2: write the site's parameters.")
                        .with(kilobits(module.airRate), kilobits(site.airRate)));
  if (module.baud != site.baud)
    found.push_back(phrase("Core", "The module's UART runs at %1 baud, the site says %2: write the site's parameters.")
                        .with(module.baud, site.baud));
  if (module.parity != site.parity)
    found.push_back(phrase(
        "Core", "The module's UART has a parity bit, vehicles and site have none: write the site's parameters."));
  if (module.address != site.address)
    found.push_back(
        phrase("Core", "The module has the address %1, those of the vehicles have %2: write the site's parameters.")
            .with(hex(module.address), hex(site.address)));
  if (module.fixedTransmission != site.fixedTransmission)
    found.push_back(phrase("Core",
                           "The module takes the first bytes of each packet for an address (fixed transmission), which "
                           "destroys frames: write the site's parameters."));
  if (module.forwardErrorCorrection != site.forwardErrorCorrection)
    found.push_back(phrase("Core",
                           "The module's error correction is off, that of the vehicles is on, so that they do not hear "
                           "each other: write the site's parameters."));
  return found;
}

void RadioFindings::moduleChanged(const E32Parameters& now) {
  RadioFindings anew;
  anew.site = site;
  anew.module = now;
  *this = anew;
}

std::vector<Sentence> radioAdvice(const RadioFindings& f) {
  std::vector<Sentence> advice;
  if (f.module) advice = differencesFromSite(*f.module, f.site);
  const bool matches = f.module && advice.empty();
  if (f.wrongKey)
    advice.push_back(
        phrase("Core",
               "A vehicle answers with another key than the site's, so the radio is right: pair it, or enter "
               "its key in the site."));
  if (f.foreign > 0)
    advice.push_back(
        phrase("Core",
               "Vehicles are heard that the site does not have, so the radio is right: compare the vehicles' "
               "addresses with the site's, or choose a channel that nobody else uses."));
  const bool heardLately = f.lastHeard && *f.lastHeard < kLately;
  const bool told = f.wrongKey || f.foreign > 0 || (f.module && !matches);
  if (!heardLately && !told && f.listened >= kEnough) adviseOnSilence(f, matches, advice);
  return advice;
}

}  // namespace tessera::link
