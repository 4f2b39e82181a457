#include "floor/random_site.h"

#include <array>
#include <random>

#include "floor/route_legs.h"

namespace tessera::floor {
namespace {

class Maker {
public:
  explicit Maker(std::uint64_t seed) : random_{seed} {}

  Site site() {
    Site s;
    s.name = name();
    s.northToY = angle();
    s.radio = {whole(0, 31), std::array{300.0, 2400.0, 19200.0}[static_cast<std::size_t>(whole(0, 2))], 9600};
    fill(s.tileTypes, 4, [this] { return type(); });
    fill(s.tiles, 8, [this] { return tile(); });
    fill(s.placements, 8, [this] { return Placement{name(), point(), whole(0, 3)}; });
    fill(s.looseTags, 5, [this] { return LooseTag{uid(), point()}; });
    fill(s.zones, 4, [this] { return zone(); });
    fill(s.routes, 3, [this] { return route(); });
    fill(s.vehicles, 3, [this] { return vehicle(); });
    if (coin()) s.backdrop = backdrop();
    return s;
  }

private:
  double number(double low, double high) {
    const double v = std::uniform_real_distribution<double>{low, high}(random_);
    // Both the awkward doubles that are computed and the round ones that people write.
    return coin() ? v : std::round(v * 1000.0) / 1000.0;
  }
  int whole(int low, int high) { return std::uniform_int_distribution<int>{low, high}(random_); }
  bool coin() { return whole(0, 1) == 1; }
  Radians angle() { return coin() ? fromDegrees(whole(-360, 360)) : Radians{number(-6.28, 6.28)}; }
  Point point() { return {Metres{number(-1000, 1000)}, Metres{number(-1, 1)}}; }
  Offset offset() { return {Metres{number(-1, 1)}, Metres{number(-1, 1)}}; }
  std::string name() {
    static const std::array<std::string, 8> pieces{"T", "-", "1", "\"", "\\", "地", "\t", "é"};
    std::string s;
    for (int i = whole(1, 12); i > 0; --i) s += pieces[static_cast<std::size_t>(whole(0, 7))];
    return s;
  }
  TagUid uid() {
    std::array<std::uint8_t, 10> bytes{};
    for (auto& b : bytes) b = static_cast<std::uint8_t>(whole(0, 255));
    return *TagUid::fromBytes(std::span{bytes}.first(static_cast<std::size_t>(4 + 3 * whole(0, 2))));
  }
  template <class Items, class Make>
  void fill(Items& items, int most, Make make) {
    for (int i = whole(0, most); i > 0; --i) items.push_back(make());
  }

  TileType type() {
    TileType t;
    t.name = name();
    t.columns = whole(1, 5);
    t.rows = whole(1, 5);
    t.pitch = Metres{number(0.05, 0.2)};
    t.margin = {t.pitch / 2.0, t.pitch / 3.0};
    t.width = t.columns * t.pitch;
    t.height = t.rows * t.pitch;
    t.pattern = static_cast<Pattern>(whole(0, 2));
    t.startsWithGap = t.pattern == Pattern::OneInTwo && coin();
    for (int i = t.pattern == Pattern::Custom ? t.columns * t.rows : 0; i > 0; --i) t.custom.push_back(coin());
    return t;
  }
  Tile tile() {
    Tile t{name(), name(), {}};
    fill(t.uids, 12, [this] { return coin() ? uid() : TagUid{}; });
    return t;
  }
  Zone zone() {
    Zone z{name(), static_cast<ZoneKind>(whole(0, 7)), {point(), point(), point()}, {}, {}};
    if (coin()) z.speed = MetresPerSecond{number(0.01, 2)};
    if (coin()) z.direction = angle();
    return z;
  }
  Route route() {
    Route r{name(), {point(), point()}, Metres{number(0.01, 1)}};
    fill(r.vertices, 6, [this] { return point(); });
    if (coin()) {
      for (std::size_t leg = 0; leg < legCount(r); ++leg)
        r.legSpeeds.push_back(coin() ? std::optional{MetresPerSecond{number(0.01, 2)}} : std::nullopt);
      tidyLegSpeeds(r);
    }
    return r;
  }
  Backdrop backdrop() {
    Backdrop b{name(), nullptr, point(), Metres{number(0.001, 1)}, angle(), number(0, 1)};
    // Of any length, so that its text ends in every way.
    std::string bytes = coin() ? "\x89PNG\r\n\x1A\n" : "\xFF\xD8\xFF";
    for (int i = whole(0, 20); i > 0; --i) bytes += static_cast<char>(whole(0, 255));
    b.picture = std::make_shared<const std::string>(std::move(bytes));
    return b;
  }
  VehicleSetup vehicle() {
    VehicleSetup v;
    v.id.value = static_cast<std::uint8_t>(whole(1, 254));
    v.name = name();
    for (auto& byte : v.key) byte = static_cast<std::uint8_t>(whole(0, 255));
    v.readers.push_back(offset());
    fill(v.readers, 7, [this] { return offset(); });
    v.readerRadius = Metres{number(0.01, 0.2)};
    v.footprint = {point(), point(), point()};
    v.track = Metres{number(0.1, 1)};
    v.maxSpeed = MetresPerSecond{number(0.1, 2)};
    v.maxTurnRate = RadiansPerSecond{number(0.1, 2)};
    v.acceleration = MetresPerSecond2{number(0.1, 2)};
    if (coin()) v.cornerCut = Metres{number(0, 0.5)};
    if (coin()) v.start = Pose{point(), angle()};
    return v;
  }

  std::mt19937_64 random_;
};

}  // namespace

Site randomSite(std::uint64_t seed) { return Maker{seed}.site(); }

}  // namespace tessera::floor
