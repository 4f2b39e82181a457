#include "store/migrations.h"

#include <algorithm>
#include <array>
#include <span>

#include "base/sentence.h"
#include "store/transaction.h"

namespace tessera::store {
namespace {

// Measured values stand in columns without a type: SQLite turns -0.0 into 0.0 in a REAL column, and a site must come
// back bit by bit. Rows of a site are numbered in the order of the site.
constexpr std::array kSites{
    "CREATE TABLE site(id INTEGER PRIMARY KEY, key TEXT NOT NULL UNIQUE, name TEXT NOT NULL, saved_ms INTEGER NOT NULL,"
    " differs INTEGER NOT NULL, north_to_y NOT NULL, channel INTEGER NOT NULL, air_rate NOT NULL, baud INTEGER NOT "
    "NULL)",
    "CREATE TABLE section(site INTEGER NOT NULL REFERENCES site ON DELETE CASCADE, name TEXT NOT NULL,"
    " fingerprint BLOB NOT NULL, PRIMARY KEY(site, name)) WITHOUT ROWID",
    "CREATE TABLE tile_type(site INTEGER NOT NULL REFERENCES site ON DELETE CASCADE, nr INTEGER NOT NULL, name TEXT NOT"
    " NULL, width NOT NULL, height NOT NULL, pitch NOT NULL, margin_x NOT NULL, margin_y NOT NULL, columns INTEGER NOT"
    " NULL, rows INTEGER NOT NULL, pattern TEXT NOT NULL, starts_with_gap INTEGER NOT NULL, custom TEXT NOT NULL,"
    " PRIMARY KEY(site, nr)) WITHOUT ROWID",
    "CREATE TABLE tile(site INTEGER NOT NULL REFERENCES site ON DELETE CASCADE, nr INTEGER NOT NULL, serial TEXT NOT"
    " NULL, type TEXT NOT NULL, PRIMARY KEY(site, nr)) WITHOUT ROWID",
    // uid NULL: a place whose tag is not registered.
    "CREATE TABLE tag(site INTEGER NOT NULL REFERENCES site ON DELETE CASCADE, tile INTEGER NOT NULL, nr INTEGER NOT"
    " NULL, uid BLOB, PRIMARY KEY(site, tile, nr)) WITHOUT ROWID",
    "CREATE TABLE placement(site INTEGER NOT NULL REFERENCES site ON DELETE CASCADE, nr INTEGER NOT NULL, serial TEXT"
    " NOT NULL, x NOT NULL, y NOT NULL, quarter_turns INTEGER NOT NULL, PRIMARY KEY(site, nr)) WITHOUT ROWID",
    "CREATE TABLE loose_tag(site INTEGER NOT NULL REFERENCES site ON DELETE CASCADE, nr INTEGER NOT NULL, uid BLOB,"
    " x NOT NULL, y NOT NULL, PRIMARY KEY(site, nr)) WITHOUT ROWID",
    "CREATE TABLE zone(site INTEGER NOT NULL REFERENCES site ON DELETE CASCADE, nr INTEGER NOT NULL, name TEXT NOT "
    "NULL,"
    " kind TEXT NOT NULL, speed, direction, PRIMARY KEY(site, nr)) WITHOUT ROWID",
    "CREATE TABLE zone_point(site INTEGER NOT NULL REFERENCES site ON DELETE CASCADE, zone INTEGER NOT NULL, nr INTEGER"
    " NOT NULL, x NOT NULL, y NOT NULL, PRIMARY KEY(site, zone, nr)) WITHOUT ROWID",
    "CREATE TABLE route(site INTEGER NOT NULL REFERENCES site ON DELETE CASCADE, nr INTEGER NOT NULL, name TEXT NOT"
    " NULL, control_spacing NOT NULL, PRIMARY KEY(site, nr)) WITHOUT ROWID",
    "CREATE TABLE route_vertex(site INTEGER NOT NULL REFERENCES site ON DELETE CASCADE, route INTEGER NOT NULL, nr"
    " INTEGER NOT NULL, x NOT NULL, y NOT NULL, PRIMARY KEY(site, route, nr)) WITHOUT ROWID",
    "CREATE TABLE vehicle(site INTEGER NOT NULL REFERENCES site ON DELETE CASCADE, nr INTEGER NOT NULL, id INTEGER NOT"
    " NULL, name TEXT NOT NULL, key BLOB NOT NULL, reader_radius NOT NULL, track NOT NULL, wheel_diameter NOT NULL,"
    " max_speed NOT NULL, max_turn_rate NOT NULL, acceleration NOT NULL, start_x, start_y, start_heading,"
    " PRIMARY KEY(site, nr)) WITHOUT ROWID",
    "CREATE TABLE vehicle_reader(site INTEGER NOT NULL REFERENCES site ON DELETE CASCADE, vehicle INTEGER NOT NULL, nr"
    " INTEGER NOT NULL, x NOT NULL, y NOT NULL, PRIMARY KEY(site, vehicle, nr)) WITHOUT ROWID",
    "CREATE TABLE vehicle_footprint(site INTEGER NOT NULL REFERENCES site ON DELETE CASCADE, vehicle INTEGER NOT NULL,"
    " nr INTEGER NOT NULL, x NOT NULL, y NOT NULL, PRIMARY KEY(site, vehicle, nr)) WITHOUT ROWID",
};

constexpr std::array kJournal{
    // severity: 0 info, 1 warning, 2 error. pattern and args: the sentence's parts, for other languages.
    "CREATE TABLE journal(id INTEGER PRIMARY KEY, utc_ms INTEGER NOT NULL, site TEXT NOT NULL, vehicle INTEGER,"
    " severity INTEGER NOT NULL, kind TEXT NOT NULL, over INTEGER NOT NULL, sentence TEXT NOT NULL, pattern TEXT, args "
    "TEXT)",
    "CREATE INDEX journal_by_time ON journal(utc_ms)",
    "CREATE INDEX journal_by_vehicle ON journal(vehicle, utc_ms)",
};

// The picture apart from where it lies: it is long, and moved more often than changed.
constexpr std::array kBackdrops{
    "CREATE TABLE backdrop(site INTEGER PRIMARY KEY REFERENCES site ON DELETE CASCADE, file TEXT NOT NULL, x NOT NULL,"
    " y NOT NULL, pixel NOT NULL, turn NOT NULL, opacity NOT NULL)",
    "CREATE TABLE backdrop_picture(site INTEGER PRIMARY KEY REFERENCES site ON DELETE CASCADE, picture BLOB NOT NULL)",
};

constexpr std::array kRevisions{
    // text: a compressed site file that holds this part alone; bytes: its length.
    "CREATE TABLE revision_part(id INTEGER PRIMARY KEY, digest BLOB NOT NULL UNIQUE, bytes INTEGER NOT NULL, text BLOB"
    " NOT NULL)",
    // key: as in site, but what is no longer kept there has its revisions still. Numbers of changes NULL: unknown.
    "CREATE TABLE revision(id INTEGER PRIMARY KEY, key TEXT NOT NULL, saved_ms INTEGER NOT NULL, who TEXT NOT NULL,"
    " what TEXT NOT NULL, found INTEGER NOT NULL, floor INTEGER NOT NULL REFERENCES revision_part, picture INTEGER NOT"
    " NULL REFERENCES revision_part, rest INTEGER NOT NULL REFERENCES revision_part, laid INTEGER, moved INTEGER,"
    " taken_up INTEGER, tags INTEGER, zones INTEGER, routes INTEGER, vehicles INTEGER, others INTEGER)",
    "CREATE INDEX revision_by_key ON revision(key, id)",
};

constexpr std::array kLegSpeeds{
    // Of the leg that begins at the vertex; NULL: as ordered.
    "ALTER TABLE route_vertex ADD COLUMN leg_speed",
};

constexpr std::array kMagneticMaps{
    // key: as in revision. nodes: as locate/magnetic_file.h writes them.
    "CREATE TABLE magnetic_map(key TEXT NOT NULL, simulated INTEGER NOT NULL, saved_ms INTEGER NOT NULL,"
    " nodes BLOB NOT NULL, PRIMARY KEY(key, simulated))",
};

constexpr std::array kCornerCuts{
    // 0: it turns on the spot.
    "ALTER TABLE vehicle ADD COLUMN corner_cut NOT NULL DEFAULT 0",
};

constexpr std::array<std::span<const char* const>, 7> kSteps{kSites,     kJournal,      kBackdrops, kRevisions,
                                                             kLegSpeeds, kMagneticMaps, kCornerCuts};

constexpr int kApplicationId = 0x54455353;  // "TESS", by which `file` and this program know their own

qint64 numberFrom(Transaction& reading, const char* sql) {
  Statement row{reading, QLatin1String{sql}};
  row.run();
  return row.next() ? row.whole(0) : 0;
}

/// 0: an empty file; -1: not one of this program's.
Result<int> versionOf(Transaction& reading) {
  qint64 version = 0;
  if (numberFrom(reading, "SELECT count(*) FROM sqlite_schema") > 0) {
    const bool own = numberFrom(reading, "PRAGMA application_id") == kApplicationId &&
                     numberFrom(reading, "SELECT count(*) FROM sqlite_schema WHERE name='schema_version'") == 1;
    version = own ? numberFrom(reading, "SELECT max(version) FROM schema_version") : -1;
  }
  if (reading.failed()) return tl::unexpected{*reading.error()};
  return static_cast<int>(version);
}

}  // namespace

int newestVersion() { return static_cast<int>(kSteps.size()); }

Result<int> checkVersion(Database& database) {
  Transaction reading{database, Transaction::Kind::Read};
  const auto version = versionOf(reading);
  if (!version) return tl::unexpected{version.error()};
  const std::string name = database.path().string();
  if (*version < 0)
    return failure(
        phrase("Core", "%1: is a database of another program. It was left as it is: choose another place.").with(name));
  if (*version > newestVersion())
    return failure(phrase("Core",
                          "%1: was made by a newer version of Tessera (layout %2, this program knows up to %3). It was"
                          " left as it is: please install the newer version.")
                       .with(name, *version, newestVersion()));
  return *version;
}

Result<void> migrate(Database& database, int from) {
  for (int step = from + 1; step <= newestVersion(); ++step) {
    Transaction writing{database, Transaction::Kind::WriteThrough};
    // Asked again within the transaction: another copy of the program may have been quicker.
    const auto version = versionOf(writing);
    if (!version) return tl::unexpected{version.error()};
    if (*version >= step) continue;
    if (step == 1) {
      writing.run(QStringLiteral("CREATE TABLE schema_version(version INTEGER PRIMARY KEY)"));
      writing.run(QStringLiteral("PRAGMA application_id=%1").arg(kApplicationId));
    }
    for (const char* sql : kSteps[static_cast<std::size_t>(step - 1)]) writing.run(QLatin1String{sql});
    writing.run(QStringLiteral("INSERT INTO schema_version VALUES(?)"), {step});
    if (auto done = writing.commit(); !done) return done;
  }
  return {};
}

}  // namespace tessera::store
