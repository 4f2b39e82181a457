#include "locate/magnetic_file.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "wire/bytes.h"

namespace tessera::locate {
namespace {

constexpr std::array<std::uint8_t, 4> kMagic{'T', 'M', 'A', 'G'};
constexpr std::uint8_t kLayout = 1;
constexpr std::size_t kHead = 4 + 1 + 2 + 4;  // magic, layout, spacing in mm, number of nodes
constexpr std::size_t kNode = 5 * 4;          // column, row, deviation and its sigma in µrad, visits
constexpr std::size_t kSum = 4;
constexpr double kMicro = 1e-6;

/// FNV-1a of 32 bits.
std::uint32_t sumOf(std::span<const std::uint8_t> bytes) {
  std::uint32_t h = 0x811c9dc5U;
  for (const std::uint8_t b : bytes) h = (h ^ b) * 0x01000193U;
  return h;
}

std::uint16_t spacing() { return static_cast<std::uint16_t>(std::lround(MagneticMap::kSpacing.value() * 1000.0)); }

}  // namespace

std::vector<std::uint8_t> bytesOf(const MagneticMap& map) {
  const std::size_t count = map.nodeCount();
  std::vector<std::uint8_t> bytes(kHead + count * kNode + kSum);
  wire::ByteWriter out{bytes};
  out.bytes(kMagic);
  out.u8(kLayout);
  out.u16(spacing());
  out.u32(static_cast<std::uint32_t>(count));
  map.forEach([&](MagneticNode node, const MagneticValue& value) {
    out.i32(node.column);
    out.i32(node.row);
    out.i32(static_cast<std::int32_t>(std::lround(value.deviation / kMicro)));
    out.u32(static_cast<std::uint32_t>(std::lround(std::sqrt(value.variance) / kMicro)));
    out.u32(value.visits);
  });
  out.u32(sumOf(out.written()));
  return bytes;
}

Result<MagneticMap> magneticMapFrom(std::span<const std::uint8_t> bytes) {
  wire::ByteReader in{bytes};
  const wire::Bytes magic = in.bytes(kMagic.size());
  if (!std::equal(magic.begin(), magic.end(), kMagic.begin(), kMagic.end()))
    return failure(phrase("Core", "These bytes are no magnetic map."));
  if (in.u8() != kLayout) return failure(phrase("Core", "The magnetic map was made by another version of Tessera."));
  const bool sameGrid = in.u16() == spacing();
  const std::size_t count = in.u32();
  if (in.overrun() || in.remaining() < kSum || (in.remaining() - kSum) % kNode != 0 ||
      (in.remaining() - kSum) / kNode != count)
    return failure(phrase("Core", "The magnetic map is cut short or too long."));
  if (wire::ByteReader sum{bytes.last(kSum)}; sum.u32() != sumOf(bytes.first(bytes.size() - kSum)))
    return failure(phrase("Core", "The magnetic map is damaged."));
  if (!sameGrid) return failure(phrase("Core", "The magnetic map has another grid than this version of Tessera."));
  MagneticMap map;
  for (std::size_t i = 0; i < count; ++i) {
    MagneticNode node;
    MagneticValue value;
    node.column = in.i32();
    node.row = in.i32();
    value.deviation = in.i32() * kMicro;
    const double sigma = in.u32() * kMicro;
    value.variance = sigma * sigma;
    value.visits = in.u32();
    if (!map.put(node, value)) return failure(phrase("Core", "The magnetic map holds numbers that no map has."));
  }
  return map;
}

}  // namespace tessera::locate
