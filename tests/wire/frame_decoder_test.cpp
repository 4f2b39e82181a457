// The decoder against streams with noise, halves of frames, and frames hidden in what looked like another frame.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "wire/frame.h"

namespace tessera::wire {
namespace {

using Stream = std::vector<std::uint8_t>;

struct Got {
  FrameHeader header;
  Stream payload;
  bool operator==(const Got&) const = default;
};

class Decoder {
public:
  void feed(Bytes bytes) {
    decoder_.feed(bytes, [this](const Frame& f) { take(f); });
  }
  void flush() {
    decoder_.flush([this](const Frame& f) { take(f); });
  }
  [[nodiscard]] const std::vector<Got>& got() const { return got_; }
  [[nodiscard]] const FrameDecoder& decoder() const { return decoder_; }

private:
  void take(const Frame& f) { got_.push_back({f.header, Stream(f.payload.begin(), f.payload.end())}); }
  FrameDecoder decoder_;
  std::vector<Got> got_;
};

Stream encoded(const Got& frame) {
  Stream out(kMaxFrame);
  out.resize(encodeFrame(frame.header, frame.payload, out));
  return out;
}

void append(Stream& to, const Stream& more) { to.insert(to.end(), more.begin(), more.end()); }

// Stretches of the stream, wherever they begin, that have a frame's form and checksum: the frames sent, and about one
// false start in 65,536, which no decoder can tell from a frame.
std::size_t framesInside(const Stream& stream) {
  std::size_t n = 0;
  for (std::size_t at = 0; at + kFrameOverhead <= stream.size(); ++at) {
    const std::size_t size = stream[at + 1] + kFrameOverhead;
    if (stream[at] != kSync || size > kMaxFrame || at + size > stream.size()) continue;
    const std::uint16_t crc = crc16(Bytes{stream}.subspan(at + 1, size - 3));
    if (stream[at + size - 2] == (crc & 0xFF) && stream[at + size - 1] == (crc >> 8)) ++n;
  }
  return n;
}

class RandomStreams : public ::testing::Test {
protected:
  std::size_t below(std::size_t n) { return random_() % n; }
  // Noise in which sync bytes and plausible lengths are far more frequent than by chance.
  Stream noise(std::size_t longest) {
    Stream s(below(longest + 1));
    for (auto& byte : s) {
      byte = below(4) == 0 ? kSync : static_cast<std::uint8_t>(below(4) == 0 ? below(50) : random_());
    }
    return s;
  }
  Got frame() {
    Got f{{byte(), byte(), byte(), static_cast<std::uint16_t>(random_())}, noise(kMaxPayload)};
    return f;
  }
  std::uint8_t byte() { return static_cast<std::uint8_t>(random_()); }
  // Gives the stream in pieces of chance length, as a serial port does.
  void feedInPieces(Decoder& d, const Stream& stream) {
    for (std::size_t at = 0; at < stream.size();) {
      const std::size_t n = std::min(stream.size() - at, below(70));
      d.feed(Bytes{stream}.subspan(at, n));
      at += n;
    }
  }

private:
  std::mt19937_64 random_{58};
};

TEST_F(RandomStreams, everyGoodFrameIsFoundBetweenNoise) {
  int chances = 0;
  for (int round = 0; round < 3000; ++round) {
    Stream stream;
    std::vector<Got> sent;
    for (std::size_t k = below(6); k > 0; --k) {
      append(stream, noise(80));
      sent.push_back(frame());
      append(stream, encoded(sent.back()));
    }
    append(stream, noise(80));
    if (framesInside(stream) != sent.size()) {
      ++chances;
      continue;
    }
    Decoder d;
    feedInPieces(d, stream);
    d.flush();
    ASSERT_EQ(d.got(), sent) << round;
    ASSERT_FALSE(d.decoder().pending());
  }
  EXPECT_LT(chances, 30);
}

TEST_F(RandomStreams, damagedFramesHideNoGoodOne) {
  int chances = 0;
  for (int round = 0; round < 3000; ++round) {
    Stream stream;
    std::vector<Got> sent;
    for (int k = 0; k < 6; ++k) {
      const Got f = frame();
      Stream bytes = encoded(f);
      switch (below(4)) {
        case 0:  // some bytes changed
          for (int i = 0; i < 3; ++i) bytes[below(bytes.size())] ^= static_cast<std::uint8_t>(1 + below(255));
          break;
        case 1:  // cut short
          bytes.resize(below(bytes.size()));
          break;
        default:
          sent.push_back(f);
      }
      append(stream, bytes);
    }
    if (framesInside(stream) != sent.size()) {
      ++chances;
      continue;
    }
    Decoder d;
    feedInPieces(d, stream);
    d.flush();
    ASSERT_EQ(d.got(), sent) << round;
  }
  EXPECT_LT(chances, 30);
}

TEST_F(RandomStreams, oneChangedBitIsRefused) {
  for (int round = 0; round < 200; ++round) {
    const Stream good = encoded(frame());
    for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
      Stream bad = good;
      bad[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
      Decoder d;
      d.feed(bad);
      d.flush();
      ASSERT_TRUE(d.got().empty()) << "round " << round << ", bit " << bit;
    }
  }
}

TEST_F(RandomStreams, everyByteIsAccountedFor) {
  for (int round = 0; round < 1000; ++round) {
    Stream stream = noise(300);
    const Got f = frame();
    append(stream, encoded(f));
    append(stream, noise(300));
    Decoder d;
    feedInPieces(d, stream);
    d.flush();
    std::size_t inFrames = 0;
    for (const Got& g : d.got()) inFrames += g.payload.size() + kFrameOverhead;
    ASSERT_EQ(d.decoder().counters().skipped + inFrames, stream.size());
    ASSERT_EQ(d.decoder().counters().frames, d.got().size());
  }
}

TEST(FrameDecoder, aFullStretchOfSyncBytesOverrunsNothing) {
  Decoder d;
  d.feed(Stream(10'000, kSync));
  d.feed(encoded({{1, 0, 2, 3}, {}}));
  d.flush();
  ASSERT_EQ(d.got().size(), 1U);
}

TEST(FrameDecoder, theLongestFrameIsTaken) {
  const Got longest{{1, 0, 2, 3}, Stream(kMaxPayload, kSync)};
  Decoder d;
  for (int i = 0; i < 3; ++i) d.feed(encoded(longest));
  EXPECT_EQ(d.got(), (std::vector<Got>{longest, longest, longest}));
}

TEST(FrameDecoder, findsTheFrameInsideAHalfFrameAtASilence) {
  const Got inner{{0, 1, 0x82, 9}, {1, 2, 3}};
  Stream stream{kSync, 49, 1, 0};  // the beginning of a long frame whose rest was lost
  append(stream, encoded(inner));
  Decoder d;
  d.feed(stream);
  EXPECT_TRUE(d.got().empty()) << "as yet it may be the long frame's payload";
  EXPECT_TRUE(d.decoder().pending());
  d.flush();
  EXPECT_EQ(d.got(), std::vector<Got>{inner});
  EXPECT_FALSE(d.decoder().pending());
}

TEST(FrameDecoder, aFrameInsideAGoodFramesPayloadIsItsPayload) {
  const Got inner{{0, 1, 0x82, 9}, {1, 2, 3}};
  const Got outer{{1, 0, 2, 3}, encoded(inner)};
  Decoder d;
  d.feed(encoded(outer));
  d.flush();
  EXPECT_EQ(d.got(), std::vector<Got>{outer});
}

TEST(FrameDecoder, countsWhatLookedLikeAFrameAndWasNone) {
  Stream bytes = encoded({{1, 0, 2, 3}, {7, 7}});
  bytes.back() ^= 1;
  Decoder d;
  d.feed(bytes);
  EXPECT_EQ(d.decoder().counters().badCrc, 1U);
  EXPECT_EQ(d.decoder().counters().frames, 0U);
}

}  // namespace
}  // namespace tessera::wire
