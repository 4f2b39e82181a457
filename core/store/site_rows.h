// A site as rows of tables: one description for what is written and for the fingerprint that tells whether it has to
// be. A Sink has row(Table, values...), the values in the order of the table's columns after `site`. The bindings name
// every member, so that one added to the site's structures does not compile until it is kept here as well.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "floor/site.h"
#include "floor/site_names.h"

namespace tessera::store {

enum class Table {
  TileType,
  Tile,
  Tag,
  Placement,
  LooseTag,
  Zone,
  ZonePoint,
  Route,
  RouteVertex,
  Vehicle,
  VehicleReader,
  VehicleFootprint,
  Backdrop,
  BackdropPicture,
};
inline constexpr std::array<std::string_view, 14> kTableNames{
    "tile_type", "tile",         "tag",     "placement",      "loose_tag",         "zone",     "zone_point",
    "route",     "route_vertex", "vehicle", "vehicle_reader", "vehicle_footprint", "backdrop", "backdrop_picture"};

inline std::optional<double> valueOf(const auto& quantity) {
  return quantity ? std::optional{quantity->value()} : std::nullopt;
}

/// Points or offsets of the item with number `owner`.
template <class Sink, class Places>
void rowsOfPlaces(Table table, std::size_t owner, const Places& places, Sink& sink) {
  for (std::size_t i = 0; i < places.size(); ++i) sink.row(table, owner, i, places[i].x.value(), places[i].y.value());
}

template <class Sink>
void rowsOf(const std::vector<floor::TileType>& types, Sink& sink) {
  for (std::size_t i = 0; i < types.size(); ++i) {
    const auto& [name, width, height, pitch, margin, columns, rows, pattern, startsWithGap, custom] = types[i];
    std::string places;
    for (const bool tag : custom) places += tag ? '#' : '.';
    sink.row(Table::TileType, i, name, width.value(), height.value(), pitch.value(), margin.x.value(), margin.y.value(),
             columns, rows, floor::kPatternNames[static_cast<std::size_t>(pattern)], startsWithGap, places);
  }
}

// Of tiles and placements, of which there are many, also one by one.
template <class Sink>
void rowsOfOne(const floor::Tile& tile, std::size_t i, Sink& sink) {
  const auto& [serial, type, uids] = tile;
  sink.row(Table::Tile, i, serial, type);
  for (std::size_t n = 0; n < uids.size(); ++n) sink.row(Table::Tag, i, n, uids[n]);
}

template <class Sink>
void rowsOfOne(const floor::Placement& placement, std::size_t i, Sink& sink) {
  const auto& [serial, origin, quarterTurns] = placement;
  sink.row(Table::Placement, i, serial, origin.x.value(), origin.y.value(), quarterTurns);
}

template <class Sink>
void rowsOf(const std::vector<floor::Tile>& tiles, Sink& sink) {
  for (std::size_t i = 0; i < tiles.size(); ++i) rowsOfOne(tiles[i], i, sink);
}

template <class Sink>
void rowsOf(const std::vector<floor::Placement>& placements, Sink& sink) {
  for (std::size_t i = 0; i < placements.size(); ++i) rowsOfOne(placements[i], i, sink);
}

template <class Sink>
void rowsOf(const std::vector<floor::LooseTag>& tags, Sink& sink) {
  for (std::size_t i = 0; i < tags.size(); ++i) {
    const auto& [uid, place] = tags[i];
    sink.row(Table::LooseTag, i, uid, place.x.value(), place.y.value());
  }
}

template <class Sink>
void rowsOf(const std::vector<floor::Zone>& zones, Sink& sink) {
  for (std::size_t i = 0; i < zones.size(); ++i) {
    const auto& [name, kind, outline, speed, direction] = zones[i];
    sink.row(Table::Zone, i, name, floor::kZoneKindNames[static_cast<std::size_t>(kind)], valueOf(speed),
             valueOf(direction));
    rowsOfPlaces(Table::ZonePoint, i, outline, sink);
  }
}

template <class Sink>
void rowsOf(const std::vector<floor::Route>& routes, Sink& sink) {
  for (std::size_t i = 0; i < routes.size(); ++i) {
    const auto& [name, vertices, controlSpacing, legSpeeds] = routes[i];
    sink.row(Table::Route, i, name, controlSpacing.value());
    // A leg's speed stands with the vertex that it begins at.
    for (std::size_t n = 0; n < vertices.size(); ++n)
      sink.row(Table::RouteVertex, i, n, vertices[n].x.value(), vertices[n].y.value(),
               n < legSpeeds.size() ? valueOf(legSpeeds[n]) : std::nullopt);
  }
}

template <class Sink>
void rowsOf(const std::vector<floor::VehicleSetup>& vehicles, Sink& sink) {
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    const auto& [id, name, key, readers, readerRadius, footprint, track, wheelDiameter, maxSpeed, maxTurnRate,
                 acceleration, cornerCut, start] = vehicles[i];
    std::optional<double> x;
    std::optional<double> y;
    std::optional<double> heading;
    if (start) {
      x = start->position.x.value();
      y = start->position.y.value();
      heading = start->heading.value();
    }
    sink.row(Table::Vehicle, i, static_cast<int>(id.value), name, key, readerRadius.value(), track.value(),
             wheelDiameter.value(), maxSpeed.value(), maxTurnRate.value(), acceleration.value(), x, y, heading,
             cornerCut.value());
    rowsOfPlaces(Table::VehicleReader, i, readers, sink);
    rowsOfPlaces(Table::VehicleFootprint, i, footprint, sink);
  }
}

/// A picture's bytes: long, and hashed and bound as they lie.
struct PictureBytes {
  std::string_view bytes;
};

template <class Sink>
void rowsOf(const std::optional<floor::Backdrop>& backdrop, Sink& sink) {
  if (!backdrop) return;
  const auto& [file, picture, origin, pixel, turn, opacity] = *backdrop;
  sink.row(Table::Backdrop, file, origin.x.value(), origin.y.value(), pixel.value(), turn.value(), opacity);
}

/// Of its own: a picture that is moved is not written again.
template <class Sink>
void rowsOf(const PictureBytes& picture, Sink& sink) {
  if (!picture.bytes.empty()) sink.row(Table::BackdropPicture, picture);
}

/// Calls visit(name of the section, its tables, its items) for each part that is written on its own.
template <class Visit>
void forEachSection(const floor::Site& site, Visit&& visit) {
  const auto& [name, northToY, radio, tileTypes, tiles, placements, looseTags, zones, routes, vehicles, backdrop] =
      site;
  visit("tile_types", std::array{Table::TileType}, tileTypes);
  visit("tiles", std::array{Table::Tag, Table::Tile}, tiles);
  visit("placements", std::array{Table::Placement}, placements);
  visit("loose_tags", std::array{Table::LooseTag}, looseTags);
  visit("zones", std::array{Table::ZonePoint, Table::Zone}, zones);
  visit("routes", std::array{Table::RouteVertex, Table::Route}, routes);
  visit("vehicles", std::array{Table::VehicleReader, Table::VehicleFootprint, Table::Vehicle}, vehicles);
  visit("backdrop", std::array{Table::Backdrop}, backdrop);
  const bool pictured = backdrop && backdrop->picture;
  visit("backdrop_picture", std::array{Table::BackdropPicture},
        PictureBytes{pictured ? std::string_view{*backdrop->picture} : std::string_view{}});
}

}  // namespace tessera::store
