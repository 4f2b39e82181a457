#include "link/e32_parameters.h"

#include <gtest/gtest.h>

namespace tessera::link {
namespace {

TEST(E32Parameters, encodeTheDataSheetsExample) {
  // Data sheet v1.2, chapter 7: the parameters of the factory.
  E32Parameters factory;
  factory.airRate = 2;
  factory.baud = 9600;
  EXPECT_EQ(encodeE32(factory).value(), (E32Registers{0xC0, 0x00, 0x00, 0x1A, 0x17, 0x44}));
  EXPECT_EQ(encodeE32(factory, false).value()[0], 0xC2) << "forgotten without power";
}

TEST(E32Parameters, encodeWhatTheProtocolAsksOfAVehicle) {
  EXPECT_EQ(encodeE32(e32ParametersFor(23, 19200, 115200).value()).value(),
            (E32Registers{0xC0, 0x00, 0x00, 0x3D, 0x17, 0x44}));
}

TEST(E32Parameters, everyAnswerOfAModuleComesBackAsItWas) {
  for (unsigned speed = 0; speed < 256; ++speed)
    for (unsigned option = 0; option < 256; ++option) {
      const E32Registers told{0xC0,
                              static_cast<std::uint8_t>(speed ^ option),
                              static_cast<std::uint8_t>(option),
                              static_cast<std::uint8_t>(speed),
                              static_cast<std::uint8_t>(option & 31U),
                              static_cast<std::uint8_t>(option)};
      const auto parameters = decodeE32(told);
      ASSERT_TRUE(parameters);
      E32Registers same = told;
      if ((speed & 7U) > 5) same[3] = static_cast<std::uint8_t>((same[3] & ~7U) | 5U);  // three numbers for one rate
      if (speed >> 6U == 3) same[3] &= 0x3FU;                                           // and two for no parity
      ASSERT_EQ(encodeE32(*parameters).value(), same) << speed << " " << option;
    }
}

TEST(E32Parameters, nameTheValueThatNoModuleHas) {
  const auto refused = [](auto change) {
    E32Parameters p;
    change(p);
    const auto encoded = encodeE32(p);
    return encoded ? std::string{} : encoded.error().sentence.english();
  };
  EXPECT_NE(refused([](auto& p) { p.channel = 32; }).find("channel 32"), std::string::npos);
  EXPECT_NE(refused([](auto& p) { p.channel = -1; }).find("channel -1"), std::string::npos);
  EXPECT_NE(refused([](auto& p) { p.airRate = 6; }).find("air rate number 6"), std::string::npos);
  EXPECT_NE(refused([](auto& p) { p.baud = 14400; }).find("14400"), std::string::npos);
  EXPECT_NE(refused([](auto& p) { p.power = 4; }).find("power step 4"), std::string::npos);
  EXPECT_NE(refused([](auto& p) { p.wakeUp = 8; }).find("wake-up step 8"), std::string::npos);
  EXPECT_FALSE(e32ParametersFor(23, 5000, 115200));
  EXPECT_FALSE(e32ParametersFor(40, 19200, 115200));
}

TEST(E32Parameters, passOverWhatIsNoAnswer) {
  EXPECT_FALSE(decodeE32({}));
  EXPECT_FALSE(decodeE32(E32Registers{0xC1, 0, 0, 0x1A, 0x17, 0x44})) << "a question";
  EXPECT_FALSE(decodeE32(E32Registers{0xC0, 0, 0, 0x1A, 0x20, 0x44})) << "no such channel";
  EXPECT_TRUE(decodeE32(E32Registers{0xC2, 0, 0, 0x1A, 0x17, 0x44}));
  EXPECT_FALSE(decodeE32Version(E32Registers{0xC3, 0x32, 0x27, 0x02}));
  const std::array<std::uint8_t, 4> version{0xC3, 0x32, 0x27, 0x02};
  EXPECT_EQ(decodeE32Version(version), (E32Version{0x32, 0x27, 0x02}));
}

}  // namespace
}  // namespace tessera::link
