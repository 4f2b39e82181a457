// The lines with which an operator of the world (a person or a test) lets things happen in it.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "sim/world.h"

namespace tessera::world {

inline constexpr const char* kCommandHelp =
    "Commands on standard input, one a line; each is answered by a line:\n"
    "  kill ID                  pull the vehicle's battery\n"
    "  start ID                 connect it (again); its EEPROM is as it was\n"
    "  push ID DX DY DTHETA     lift and set down: metres along the site's axes, degrees counter-clockwise\n"
    "  obstacle X Y R           put a post of radius R there, in metres\n"
    "  obstacle clear           take all posts away\n"
    "  ranger ID N off          pull the cable of a ranger: 0 is the left one, 1 the right one\n"
    "  ranger ID N on           put it back\n"
    "  jumpers M0 M1            those of the host's radio module: 1 1 lets its parameters be read and written over "
    "the\n"
    "                           port, 0 0 lets it carry frames again\n"
    "  noise N                  N random bytes on the air (at most 100000)\n"
    "  inject HEX               these bytes on the air, e.g. inject A5000103\n"
    "  corrupt N [from ID]      change one byte in each of the next N packets, or of those that this vehicle sends\n"
    "  drop N                   suppress the next N packets\n"
    "  replay N [TIMES]         send the Nth newest packet once more, 1 being the newest, or TIMES on end: on a busy\n"
    "                           channel the first meets another packet, and silences both sides for the next\n"
    "  pull / plug              close the serial port / open it again\n"
    "  where ID                 tell the vehicle's true pose\n"
    "  truth ID                 the same for programs: truth ID T X Y HEADING, the world's clock (CLOCK_MONOTONIC) in "
    "s,\n"
    "                           metres, radians counter-clockwise from x\n"
    "  quit                     end";

/// The serial port and the run, as far as commands reach them.
class Surroundings {
public:
  virtual ~Surroundings() = default;
  virtual Result<void> pull() = 0;
  /// The path under which the port stands now.
  virtual Result<std::string> plug() = 0;
  virtual void quit() = 0;
};

/// Carries out one line. The answer, or an error that says what is wrong with it; nothing is done then.
[[nodiscard]] Result<std::string> obey(std::string_view line, sim::World& world, Surroundings& surroundings);

}  // namespace tessera::world
