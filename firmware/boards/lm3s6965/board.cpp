#include "firmware/boards/lm3s6965/board.h"

#include "firmware/boards/lm3s6965/interrupt_lock.h"
#include "firmware/boards/lm3s6965/stack_paint.h"
#include "firmware/boards/lm3s6965/startup.h"

namespace tessera::firmware::lm3s6965 {
namespace {

constexpr std::uint32_t pin(unsigned n) { return 1U << n; }
constexpr std::uint32_t kUart0Pins = pin(0) | pin(1);      // port A
constexpr std::uint32_t kEncoderPins = 0xFU << 2;          // port A: left A, B, right A, B
constexpr std::uint32_t kPwmPins = pin(0) | pin(1);        // port B
constexpr std::uint32_t kI2cPins = pin(2) | pin(3);        // port B
constexpr std::uint32_t kDirectionPins = pin(4) | pin(5);  // port C, whose pins 0 to 3 are the debugger's
constexpr std::uint32_t kUart1Pins = pin(2) | pin(3);      // port D
constexpr std::array<std::uint32_t, kRangers> kTriggerPins = {pin(4), pin(6)};  // port D
constexpr std::array<std::uint32_t, kRangers> kEchoPins = {pin(5), pin(7)};     // port D
constexpr std::uint32_t kModePins = pin(0) | pin(1);                            // port E: M0, M1
constexpr std::uint32_t kAuxPin = pin(2);                                       // port E

constexpr std::uint32_t kTickMicros = 10'000;
constexpr std::uint32_t kWakeUpHz = 1000;
constexpr std::uint32_t kTriggerMicros = 12;  // at least 10 are asked; a microsecond may have been half over

// Interrupt handlers have no argument: this is how they find the board.
Lm3s6965Board* running = nullptr;

void makeOutputs(GpioRegisters& port, std::uint32_t pins) {
  port.DATA[pins] = 0;
  port.DIR = port.DIR | pins;
  port.DEN = port.DEN | pins;
}
void makeInputs(GpioRegisters& port, std::uint32_t pins) {
  port.DIR = port.DIR & ~pins;
  port.PUR = port.PUR | pins;
  port.DEN = port.DEN | pins;
}
void makePeripheral(GpioRegisters& port, std::uint32_t pins) {
  port.AFSEL = port.AFSEL | pins;
  port.DEN = port.DEN | pins;
}
void interruptOnBothEdges(GpioRegisters& port, std::uint32_t pins) {
  port.IM = port.IM & ~pins;
  port.IS = port.IS & ~pins;
  port.IBE = port.IBE | pins;
  port.ICR = pins;
  port.IM = port.IM | pins;
}

void setUpPins() {
  makePeripheral(gpioA(), kUart0Pins);
  makeInputs(gpioA(), kEncoderPins);
  gpioB().ODR = gpioB().ODR | kI2cPins;
  makePeripheral(gpioB(), kPwmPins | kI2cPins);
  makeOutputs(gpioC(), kDirectionPins);
  makePeripheral(gpioD(), kUart1Pins);
  makeOutputs(gpioD(), kTriggerPins[0] | kTriggerPins[1]);
  // Without a ranger the line would float: it rests low, as the ranger's own output does.
  gpioD().PDR = gpioD().PDR | kEchoPins[0] | kEchoPins[1];
  gpioD().DEN = gpioD().DEN | kEchoPins[0] | kEchoPins[1];
  makeOutputs(gpioE(), kModePins);
  makeInputs(gpioE(), kAuxPin);
}

void startWakeUps() {
  timer0().CTL = 0;
  timer0().CFG = 0;   // one 32-bit timer
  timer0().TAMR = 2;  // periodic
  timer0().TAILR = kClockHz / kWakeUpHz - 1;
  timer0().ICR = 1;
  timer0().IMR = 1;  // time-out
  timer0().CTL = 1;
}

void letIn(Interrupt number) { *nvicEnable() = 1U << static_cast<unsigned>(number); }

}  // namespace

Lm3s6965Board::Lm3s6965Board()
    : clock_{sysTick()},
      radio_{uart0()},
      readers_{uart1()},
      i2c_{i2c0()},
      motors_{pwm(), gpioC(), pin(4), pin(5)},
      watchdog_{watchdog0()},
      ticks_{clock_.now(), kTickMicros} {
  watchdog_.start();
  setUpPins();
  radio_.setBaud(9600);
  readers_.setBaud(38400);
  running = this;
  startWakeUps();
  encoders_[0].start(gpioA().DATA[kEncoderPins] >> 2);
  encoders_[1].start(gpioA().DATA[kEncoderPins] >> 4);
  interruptOnBothEdges(gpioA(), kEncoderPins);
  interruptOnBothEdges(gpioD(), kEchoPins[0] | kEchoPins[1]);
  for (Interrupt number :
       {Interrupt::GpioA, Interrupt::GpioD, Interrupt::Uart0, Interrupt::Uart1, Interrupt::Timer0A}) {
    letIn(number);
  }
}

void Lm3s6965Board::idle() {
  // With interrupts held off, one that comes after the question still ends the sleep.
  const InterruptLock lock;
  if (!awake_) asm volatile("dsb\n\twfi" ::: "memory");
  awake_ = false;
}

void Lm3s6965Board::setRadioMode(RadioMode mode) { gpioE().DATA[kModePins] = static_cast<std::uint32_t>(mode); }

bool Lm3s6965Board::radioReady() { return gpioE().DATA[kAuxPin] != 0; }

void Lm3s6965Board::ping(std::size_t ranger) {
  if (ranger >= kRangers) return;
  {
    const InterruptLock lock;
    echoes_[ranger].begin();
  }
  gpioD().DATA[kTriggerPins[ranger]] = kTriggerPins[ranger];
  const std::uint32_t start = clock_.now();
  while (clock_.now() - start < kTriggerMicros) {
  }
  gpioD().DATA[kTriggerPins[ranger]] = 0;
}

std::uint32_t Lm3s6965Board::echo(std::size_t ranger) { return ranger < kRangers ? echoes_[ranger].length() : 0; }

wire::ResetCause Lm3s6965Board::resetCause() { return startCause(); }
void Lm3s6965Board::restart() { resetProcessor(LifeMark::Restart); }
std::uint32_t Lm3s6965Board::stackFree() { return paintedBytes(stackMemory()); }

void Lm3s6965Board::lookAtEncoders() {
  const std::uint32_t levels = gpioA().DATA[kEncoderPins];
  encoders_[0].see(levels >> 2);
  encoders_[1].see(levels >> 4);
}

void Lm3s6965Board::onPortA() {
  // Looked at both before and after the interrupt is cleared: an edge that falls between the first look and the
  // clearing is caught by the second one, and one that comes later raises the interrupt again.
  lookAtEncoders();
  gpioA().ICR = kEncoderPins;
  lookAtEncoders();
}

void Lm3s6965Board::onPortD() {
  const std::uint32_t changed = gpioD().MIS;
  gpioD().ICR = changed;
  const std::uint32_t now = clock_.now();
  for (std::size_t i = 0; i < kRangers; ++i) {
    if ((changed & kEchoPins[i]) != 0) echoes_[i].edge(gpioD().DATA[kEchoPins[i]] != 0, now);
  }
}

void Lm3s6965Board::onWakeUp() {
  timer0().ICR = 1;
  clock_.now();  // never lets the counter wrap unseen
  awake_ = true;
}

void onPortA() { running->onPortA(); }
void onPortD() { running->onPortD(); }
void onUart0() { running->onUart(Uart::Radio); }
void onUart1() { running->onUart(Uart::Readers); }
void onWakeUp() { running->onWakeUp(); }

}  // namespace tessera::firmware::lm3s6965
