// The LM3S6965's registers, as far as this board uses them. Names and offsets are those of the data sheet
// (Texas Instruments DS-LM3S6965, chapters 3 to 18) without the block's prefix; nothing here has behaviour.
#pragma once

#include <cstddef>
#include <cstdint>

namespace tessera::firmware::lm3s6965 {

using Register = volatile std::uint32_t;

/// General-purpose input/outputs (PL061). DATA is addressed by a mask: DATA[m] reads and writes the pins in m only.
struct GpioRegisters {
  Register DATA[256];
  Register DIR, IS, IBE, IEV, IM, RIS, MIS, ICR, AFSEL;
  Register reserved0[55];
  Register DR2R, DR4R, DR8R, ODR, PUR, PDR, SLR, DEN, LOCK, CR;
};
static_assert(offsetof(GpioRegisters, DIR) == 0x400 && offsetof(GpioRegisters, AFSEL) == 0x420);
static_assert(offsetof(GpioRegisters, DR2R) == 0x500 && offsetof(GpioRegisters, CR) == 0x524);

/// Universal asynchronous receiver/transmitter (PL011).
struct UartRegisters {
  Register DR, RSR, reserved0[4], FR, reserved1, ILPR, IBRD, FBRD, LCRH, CTL, IFLS, IM, RIS, MIS, ICR;
};
static_assert(offsetof(UartRegisters, FR) == 0x018 && offsetof(UartRegisters, ICR) == 0x044);

/// Inter-integrated circuit, the master's half.
struct I2cRegisters {
  Register MSA, MCS, MDR, MTPR, MIMR, MRIS, MMIS, MICR, MCR;
};
static_assert(offsetof(I2cRegisters, MCR) == 0x020);

/// General-purpose timer.
struct GptmRegisters {
  Register CFG, TAMR, TBMR, CTL, reserved0[2], IMR, RIS, MIS, ICR, TAILR;
};
static_assert(offsetof(GptmRegisters, IMR) == 0x018 && offsetof(GptmRegisters, TAILR) == 0x028);

/// One of the three generators of the pulse width modulator.
struct PwmGeneratorRegisters {
  Register CTL, INTEN, RIS, ISC, LOAD, COUNT, CMPA, CMPB, GENA, GENB, DBCTL, DBRISE, DBFALL, reserved0[3];
};
struct PwmRegisters {
  Register CTL, SYNC, ENABLE, INVERT, FAULT, INTEN, RIS, ISC, STATUS, reserved0[7];
  PwmGeneratorRegisters GENERATOR[3];
};
static_assert(offsetof(PwmRegisters, GENERATOR) == 0x040 && sizeof(PwmGeneratorRegisters) == 0x40);

struct WatchdogRegisters {
  Register LOAD, VALUE, CTL, ICR, RIS, MIS, reserved0[762], LOCK;
};
static_assert(offsetof(WatchdogRegisters, LOCK) == 0xC00);

struct SystemControlRegisters {
  Register DID0, DID1, reserved0[11], LDOPCTL, reserved1[2], SRCR0, SRCR1, SRCR2, reserved2, RIS, IMC, MISC, RESC, RCC;
  Register reserved3[3], RCC2, reserved4[35], RCGC0, RCGC1, RCGC2;
};
static_assert(offsetof(SystemControlRegisters, LDOPCTL) == 0x034 && offsetof(SystemControlRegisters, RESC) == 0x05C);
static_assert(offsetof(SystemControlRegisters, RCC2) == 0x070 && offsetof(SystemControlRegisters, RCGC0) == 0x100);

/// SysTick, of the Cortex-M3 itself.
struct SysTickRegisters {
  Register CTRL, RELOAD, CURRENT;
};

/// Interrupt numbers: positions in the vector table behind the core's sixteen.
enum class Interrupt : std::uint8_t { GpioA = 0, GpioD = 3, Uart0 = 5, Uart1 = 6, Timer0A = 19 };

#ifdef __arm__
template <class Block>
[[nodiscard]] inline Block& blockAt(std::uintptr_t address) {
  return *reinterpret_cast<Block*>(address);
}
inline WatchdogRegisters& watchdog0() { return blockAt<WatchdogRegisters>(0x40000000); }
inline GpioRegisters& gpioA() { return blockAt<GpioRegisters>(0x40004000); }
inline GpioRegisters& gpioB() { return blockAt<GpioRegisters>(0x40005000); }
inline GpioRegisters& gpioC() { return blockAt<GpioRegisters>(0x40006000); }
inline GpioRegisters& gpioD() { return blockAt<GpioRegisters>(0x40007000); }
inline GpioRegisters& gpioE() { return blockAt<GpioRegisters>(0x40024000); }
inline UartRegisters& uart0() { return blockAt<UartRegisters>(0x4000C000); }
inline UartRegisters& uart1() { return blockAt<UartRegisters>(0x4000D000); }
inline I2cRegisters& i2c0() { return blockAt<I2cRegisters>(0x40020000); }
inline PwmRegisters& pwm() { return blockAt<PwmRegisters>(0x40028000); }
inline GptmRegisters& timer0() { return blockAt<GptmRegisters>(0x40030000); }
inline SystemControlRegisters& systemControl() { return blockAt<SystemControlRegisters>(0x400FE000); }
inline SysTickRegisters& sysTick() { return blockAt<SysTickRegisters>(0xE000E010); }
inline Register* nvicEnable() { return &blockAt<Register>(0xE000E100); }
inline Register& applicationInterruptAndReset() { return blockAt<Register>(0xE000ED0C); }
#endif

}  // namespace tessera::firmware::lm3s6965
