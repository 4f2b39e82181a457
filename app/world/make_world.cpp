#include "app/world/make_world.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <utility>

#include "floor/site_json.h"
#include "sim/commission.h"
#include "sim/random_stream.h"
#include "sim/site_bounds.h"
#ifdef TESSERA_WITH_QEMU_HOST
#include "sim/qemu/qemu_host.h"
#endif

namespace tessera::world {

namespace fs = std::filesystem;

namespace {

constexpr Metres kRoomMargin{1.0};  // from the floor's edge to the hall's walls
constexpr Metres kReaderGap{0.10};
constexpr Metres kReaderRow{0.30};           // the longest row of readers
constexpr Metres kReaderNose{0.15};          // before the middle of the wheels
constexpr Metres kExtentUnknown{0.25};       // of a vehicle without a footprint
constexpr std::uint64_t kSpotSeed = 0x5907;  // spots belong to the floor, but differ from run to run by the seed

Result<sim::EepromImage> readImage(const std::string& path) {
  std::ifstream file{path, std::ios::binary};
  sim::EepromImage image{};
  file.read(reinterpret_cast<char*>(image.data()), static_cast<std::streamsize>(image.size()));
  if (!file || file.peek() != std::ifstream::traits_type::eof())
    return failure("The EEPROM file " + path + " cannot be read or does not hold exactly " +
                   std::to_string(image.size()) + " bytes.");
  return image;
}

/// To a new file that takes the old one's place, so that a crash leaves one or the other whole.
Result<void> writeImage(const std::string& path, const sim::EepromImage& image) {
  const std::string fresh = path + ".new";
  std::ofstream file{fresh, std::ios::binary | std::ios::trunc};
  file.write(reinterpret_cast<const char*>(image.data()), static_cast<std::streamsize>(image.size()));
  file.close();
  std::error_code failed;
  if (file) fs::rename(fresh, path, failed);
  if (!file || failed) return failure("Cannot write the EEPROM file " + path + ".");
  return {};
}

Metres extentOf(const floor::VehicleSetup& setup) {
  Metres extent;
  for (const Point& p : setup.footprint) extent = std::max(extent, distance(p, Point{}));
  return setup.footprint.empty() ? kExtentUnknown : extent;
}

std::string besideThisProgram(const std::string& name) {
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  return failed ? name : (program.parent_path() / name).string();
}

Result<std::vector<floor::VehicleSetup>> chosen(const floor::Site& site, const WorldOptions& o) {
  if (o.vehicles.empty()) return site.vehicles;
  std::vector<floor::VehicleSetup> found;
  for (const unsigned id : o.vehicles) {
    const auto is = [id](const floor::VehicleSetup& v) { return v.id.value == id; };
    const auto it = std::find_if(site.vehicles.begin(), site.vehicles.end(), is);
    if (it == site.vehicles.end())
      return failure("The site " + site.name + " has no vehicle with address " + std::to_string(id) + ".");
    if (std::find_if(found.begin(), found.end(), is) == found.end()) found.push_back(*it);
  }
  return found;
}

/// The floor as it lies: the tags that are dead are not there.
floor::Site withoutDeadTags(floor::Site site, const WorldOptions& o) {
  if (!o.deadTags) return site;
  sim::RandomStream random{o.seed, "dead tags"};
  for (floor::Tile& tile : site.tiles)
    for (floor::TagUid& uid : tile.uids)
      if (random.chance(*o.deadTags)) uid = {};
  std::erase_if(site.looseTags, [&](const floor::LooseTag&) { return random.chance(*o.deadTags); });
  return site;
}

/// Makes one world; the parts that all its vehicles need are worked out once.
class Maker {
public:
  Maker(const WorldOptions& options, floor::Site site) : options_{options}, site_{std::move(site)} {}

  Result<MadeWorld> make(Seconds start) {
    applyTo(site_, options_);
    auto map = floor::SiteMap::build(withoutDeadTags(site_, options_));
    if (!map) return tl::unexpected{map.error()};
    map_ = *map;
    const auto setups = chosen(site_, options_);
    if (!setups) return tl::unexpected{setups.error()};
    if (auto ready = prepareFolder(); !ready) return tl::unexpected{ready.error()};
    spots_ = sim::seededSpots(site_, options_.compassSpots ? fromDegrees(*options_.compassSpots) : sim::kSpotDeviation,
                              options_.floorSeed.value_or(options_.seed) ^ kSpotSeed);
    scene_ = sim::roomAround(site_, kRoomMargin);
    made_.world = std::make_unique<sim::World>(sim::WorldConfig{
        site_.radio, {options_.airFactor, options_.loss, Seconds{options_.delay}}, scene_, options_.seed, start});
    made_.world->tap().disturb({options_.corrupt, options_.drop, options_.replay}, options_.seed);
    for (const floor::VehicleSetup& setup : *setups)
      if (auto added = add(setup); !added) return tl::unexpected{added.error()};
    if (auto logs = openLog(); !logs) return tl::unexpected{logs.error()};
    return std::move(made_);
  }

private:
  /// Emulators keep their EEPROM in a file, wanted or not.
  Result<void> prepareFolder() {
    if (options_.eepromDir.empty() && options_.kind == Kind::Qemu) {
      auto folder = TemporaryFolder::make();
      if (!folder) return tl::unexpected{folder.error()};
      made_.folder = std::move(*folder);
    }
    if (options_.eepromDir.empty()) return {};
    std::error_code failed;
    fs::create_directories(options_.eepromDir, failed);
    if (failed) return failure("Cannot make the folder " + options_.eepromDir + ": " + failed.message() + ".");
    return {};
  }

  [[nodiscard]] bool isFresh(VehicleId id) const {
    return std::find(options_.fresh.begin(), options_.fresh.end(), id.value) != options_.fresh.end();
  }
  [[nodiscard]] static Result<sim::EepromImage> emptyEeprom() {
    sim::EepromImage image;
    image.fill(0xFF);
    return image;
  }

  [[nodiscard]] std::string eepromPath(VehicleId id) const {
    const std::string& folder = options_.eepromDir.empty() ? made_.folder.path() : options_.eepromDir;
    return folder.empty() ? std::string{} : folder + "/vehicle-" + std::to_string(id.value) + ".eeprom";
  }

  Result<void> add(const floor::VehicleSetup& setup) {
    const sim::BodyParameters body = bodyFor(setup, options_);
    const std::string path = eepromPath(setup.id);
    auto host = options_.kind == Kind::Qemu ? qemuHost(setup, body, path) : nativeHost(setup, body, path);
    if (!host) return tl::unexpected{host.error()};
    const Pose start = setup.start.value_or(Pose{});
    sim::VehicleWorldConfig config{setup, body, start, map_, site_.northToY, spots_, scene_, options_.seed};
    made_.world->add(std::make_unique<sim::VehicleBody>(config, std::move(*host)), extentOf(setup));
    made_.vehicles.push_back({setup.id, setup.name});
    return {};
  }

  Result<sim::EepromImage> image(const floor::VehicleSetup& setup, const sim::BodyParameters& body,
                                 const std::string& path) const {
    if (!path.empty() && fs::exists(path)) return readImage(path);
    auto fresh = isFresh(setup.id) ? emptyEeprom() : sim::commissionEeprom(setup, site_, body, options_.seed);
    if (!fresh)
      return failure("Cannot set up vehicle " + std::to_string(setup.id.value) + ": " +
                     fresh.error().sentence.english());
    if (!path.empty())
      if (auto written = writeImage(path, *fresh); !written) return tl::unexpected{written.error()};
    return fresh;
  }

  Result<std::unique_ptr<sim::VehicleHost>> nativeHost(const floor::VehicleSetup& setup,
                                                       const sim::BodyParameters& body, const std::string& path) {
    auto eeprom = image(setup, body, path);
    if (!eeprom) return tl::unexpected{eeprom.error()};
    auto host = std::make_unique<sim::NativeHost>(*eeprom);
    if (!path.empty()) made_.keepers.push_back({path, host.get()});
    return host;
  }

  Result<std::unique_ptr<sim::VehicleHost>> qemuHost(const floor::VehicleSetup& setup, const sim::BodyParameters& body,
                                                     const std::string& path) {
#ifdef TESSERA_WITH_QEMU_HOST
    const std::string elf = options_.firmware.empty() ? besideThisProgram("tessera-vehicle.elf") : options_.firmware;
    if (!fs::is_regular_file(elf))
      return failure("There is no firmware " + elf + ": build it (./dev build) or name it by --firmware.");
    auto eeprom = image(setup, body, path);
    if (!eeprom) return tl::unexpected{eeprom.error()};
    sim::QemuConfig config;
    config.program = elf;
    config.eeprom = path;
    return std::make_unique<sim::QemuHost>(config);
#else
    static_cast<void>(setup);
    static_cast<void>(body);
    static_cast<void>(path);
    return failure("This program was built without the emulator's host; use --kind native.");
#endif
  }

  Result<void> openLog() {
    if (options_.truth.empty()) return {};
    auto log = sim::TruthLog::open(options_.truth);
    if (!log) return tl::unexpected{log.error()};
    made_.world->setTruthLog(std::move(*log));
    return {};
  }

  const WorldOptions& options_;
  floor::Site site_;
  std::shared_ptr<const floor::SiteMap> map_;
  std::vector<sim::MagneticSpot> spots_;
  sim::Scene scene_;
  MadeWorld made_;
};

}  // namespace

void applyTo(floor::Site& site, const WorldOptions& options) {
  if (options.airRate) site.radio.airRate = *options.airRate;
  if (options.radius)
    for (floor::VehicleSetup& vehicle : site.vehicles) vehicle.readerRadius = Metres{*options.radius};
  if (!options.readers) return;
  const unsigned count = *options.readers;
  // 10 cm apart as on the publication's vehicle, closer where the row would stand out beyond its sides.
  const Metres gap = count > 1 ? std::min(kReaderGap, kReaderRow / (count - 1.0)) : Metres{};
  for (floor::VehicleSetup& vehicle : site.vehicles) {
    const Metres nose = vehicle.readers.empty() ? kReaderNose : vehicle.readers.front().x;
    vehicle.readers.clear();
    for (unsigned i = 0; i < count; ++i) vehicle.readers.push_back({nose, gap * (0.5 * (count - 1.0) - i)});
  }
}

sim::BodyParameters bodyFor(const floor::VehicleSetup& setup, const WorldOptions& o) {
  sim::BodyParameters body = sim::bodyParametersFor(setup);
  if (o.poll) body.readers.pollPeriod = Seconds{*o.poll};
  if (o.readTime) body.readers.readTime = Seconds{*o.readTime};
  if (o.detection) body.readers.detection = *o.detection;
  if (o.trueRadius) body.readers.radius = Metres{*o.trueRadius};
  if (o.slip) body.plant.slip = *o.slip;
  if (o.tyreDifference) body.plant.tyreDifference = *o.tyreDifference;
  if (o.headingLearning) body.headingLearning = Metres{*o.headingLearning};
  if (o.speedNoise) body.plant.speedNoise = *o.speedNoise;
  if (o.speedNoiseTime) body.plant.speedNoiseMemory = Seconds{*o.speedNoiseTime};
  // A sample's noise of n on one axis turns the field of strength B by n/B.
  if (o.compassNoise) body.compass.noise = sim::kEarthHorizontal * fromDegrees(*o.compassNoise).value();
  if (o.compassBias) body.compass.bias = fromDegrees(*o.compassBias);
  return body;
}

Result<TemporaryFolder> TemporaryFolder::make() {
  std::error_code failed;
  std::string name = (fs::temp_directory_path(failed) / "tessera-world-XXXXXX").string();
  if (failed || ::mkdtemp(name.data()) == nullptr) return failure("Cannot make a temporary folder " + name + ".");
  TemporaryFolder folder;
  folder.path_ = name;
  return folder;
}

TemporaryFolder::TemporaryFolder(TemporaryFolder&& other) noexcept : path_{std::exchange(other.path_, {})} {}

TemporaryFolder& TemporaryFolder::operator=(TemporaryFolder&& other) noexcept {
  std::swap(path_, other.path_);
  return *this;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

Result<void> MadeWorld::saveEeproms() const {
  for (const Keeper& keeper : keepers)
    if (auto written = writeImage(keeper.path, keeper.host->eeprom()); !written) return written;
  return {};
}

Result<MadeWorld> makeWorld(const WorldOptions& options, floor::Site site, Seconds start) {
  return Maker{options, std::move(site)}.make(start);
}

Result<MadeWorld> makeWorld(const WorldOptions& options, Seconds start) {
  auto site = floor::loadSite(options.site);
  if (!site) return tl::unexpected{site.error()};
  return makeWorld(options, std::move(*site), start);
}

}  // namespace tessera::world
