// From reset to main(): memory, clock, constructors; the vector table; and what happens on a fault.
#include "firmware/boards/lm3s6965/startup.h"

#include <array>
#include <cstddef>

#include "firmware/boards/lm3s6965/clock.h"
#include "firmware/boards/lm3s6965/stack_paint.h"

using namespace tessera::firmware::lm3s6965;

extern "C" {
// Set by the linker script; only their addresses mean anything.
extern std::uint32_t stackBottom[], stackTop[];
extern std::uint32_t dataStart[], dataEnd[], dataImage[];
extern std::uint32_t bssStart[], bssEnd[];
using Constructor = void (*)();
extern Constructor constructorsStart[], constructorsEnd[];

int program() asm("main");  // C++ lets nobody call main() by its name
[[noreturn]] void resetHandler();
[[noreturn]] void faultHandler();

// Nothing ever ends, hence nothing is destroyed at the end.
int __aeabi_atexit(void*, void (*)(void*), void*) { return 0; }
[[noreturn]] void __cxa_pure_virtual() { resetProcessor(LifeMark::Fault); }
[[noreturn]] void abort() { resetProcessor(LifeMark::Fault); }
}
namespace {

// Kept through resets: outside the memory that is cleared.
[[gnu::section(".retained")]] volatile std::uint32_t lifeMark;
tessera::wire::ResetCause cause;

void paintStack() {
  std::uint32_t* here = nullptr;
  asm volatile("mov %0, sp" : "=r"(here));
  // Through volatile, as a memset call would need the stack that it paints.
  for (volatile std::uint32_t* word = stackBottom; word < here; ++word) *word = kPaint;
}

void prepareMemory() {
  const volatile std::uint32_t* image = dataImage;
  for (volatile std::uint32_t* word = dataStart; word < dataEnd; ++word) *word = *image++;
  for (volatile std::uint32_t* word = bssStart; word < bssEnd; ++word) *word = 0;
}

}  // namespace

extern "C" void resetHandler() {
  paintStack();
  prepareMemory();
  SystemControlRegisters& control = systemControl();
  cause = decideResetCause(control.RESC, lifeMark);
  control.RESC = 0;
  // A crystal that does not swing: try anew, there is nothing that could run without its clock.
  if (!startClock(control)) resetProcessor(LifeMark::Fault);
  lifeMark = static_cast<std::uint32_t>(LifeMark::Running);
  enablePeripherals(control);
  for (Constructor* construct = constructorsStart; construct < constructorsEnd; ++construct) (*construct)();
  program();
  resetProcessor(LifeMark::Fault);
}

extern "C" void faultHandler() { resetProcessor(LifeMark::Fault); }

namespace tessera::firmware::lm3s6965 {

std::span<const volatile std::uint32_t> stackMemory() {
  return {stackBottom, static_cast<std::size_t>(stackTop - stackBottom)};
}

wire::ResetCause startCause() { return cause; }

void resetProcessor(LifeMark mark) {
  lifeMark = static_cast<std::uint32_t>(mark);
  asm volatile("dsb" ::: "memory");
  applicationInterruptAndReset() = 0x05FA0004;  // VECTKEY, SYSRESETREQ
  asm volatile("dsb" ::: "memory");
  for (;;) asm volatile("nop");
}

}  // namespace tessera::firmware::lm3s6965

namespace {

using Handler = void (*)();
constexpr std::size_t kInterrupts = 44;

struct VectorTable {
  std::uint32_t* stack = stackTop;
  Handler reset = resetHandler;
  std::array<Handler, 14> core;
  std::array<Handler, kInterrupts> interrupts;
};

// An interrupt that nobody enabled is a fault like any other.
constexpr VectorTable makeTable() {
  VectorTable table{};
  for (Handler& handler : table.core) handler = faultHandler;
  for (Handler& handler : table.interrupts) handler = faultHandler;
  const auto put = [&table](Interrupt number, Handler handler) {
    table.interrupts[static_cast<std::size_t>(number)] = handler;
  };
  put(Interrupt::GpioA, onPortA);
  put(Interrupt::GpioD, onPortD);
  put(Interrupt::Uart0, onUart0);
  put(Interrupt::Uart1, onUart1);
  put(Interrupt::Timer0A, onWakeUp);
  return table;
}

[[gnu::section(".vectors"), gnu::used]] constinit const VectorTable vectors = makeTable();

}  // namespace
