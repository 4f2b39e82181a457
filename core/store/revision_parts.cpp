#include "store/revision_parts.h"

#include <QCryptographicHash>
#include <QtEndian>
#include <utility>

#include "floor/json_node.h"
#include "floor/site_json.h"

namespace tessera::store {
namespace {

// A site file has a name; that of the site stands in one part.
constexpr const char* kNoName = "-";

}  // namespace

floor::Site partOf(const floor::Site& site, Part part) {
  floor::Site own;
  own.name = kNoName;
  switch (part) {
    case Part::Floor:
      own.tileTypes = site.tileTypes;
      own.tiles = site.tiles;
      own.placements = site.placements;
      own.looseTags = site.looseTags;
      return own;
    case Part::Picture:
      own.backdrop = site.backdrop;
      return own;
    case Part::Rest:
      break;
  }
  own.name = site.name;
  own.northToY = site.northToY;
  own.radio = site.radio;
  own.zones = site.zones;
  own.routes = site.routes;
  own.vehicles = site.vehicles;
  return own;
}

void putPart(floor::Site& site, Part part, floor::Site from) {
  switch (part) {
    case Part::Floor:
      site.tileTypes = std::move(from.tileTypes);
      site.tiles = std::move(from.tiles);
      site.placements = std::move(from.placements);
      site.looseTags = std::move(from.looseTags);
      return;
    case Part::Picture:
      site.backdrop = std::move(from.backdrop);
      return;
    case Part::Rest:
      site.name = std::move(from.name);
      site.northToY = from.northToY;
      site.radio = from.radio;
      site.zones = std::move(from.zones);
      site.routes = std::move(from.routes);
      site.vehicles = std::move(from.vehicles);
  }
}

QByteArray textOf(const floor::Site& site) { return QByteArray::fromStdString(floor::writeSite(site)); }

QByteArray digestOf(const QByteArray& text) { return QCryptographicHash::hash(text, QCryptographicHash::Blake2b_160); }

QByteArray compressed(const QByteArray& text) { return qCompress(text); }

std::optional<floor::Site> readPart(const QByteArray& compressed, const QByteArray& digest) {
  // The length that a damaged head claims must not be asked for.
  if (compressed.size() < 4 || qFromBigEndian<std::uint32_t>(compressed.constData()) > floor::kMostJson)
    return std::nullopt;
  const QByteArray text = qUncompress(compressed);
  if (digestOf(text) != digest) return std::nullopt;
  auto site = floor::parseSite({text.constData(), static_cast<std::size_t>(text.size())}, "");
  return site ? std::optional{*std::move(site)} : std::nullopt;
}

}  // namespace tessera::store
