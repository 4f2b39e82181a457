// The vehicle's program on the LM3S6965.
#include "firmware/boards/lm3s6965/board.h"
#include "firmware/vehicle/vehicle.h"

namespace {

tessera::firmware::lm3s6965::Lm3s6965Board board;
tessera::firmware::Vehicle vehicle{board};

}  // namespace

int main() {
  for (;;) {
    vehicle.poll();
    if (board.tickDue()) vehicle.tick();
    board.idle();
  }
}
