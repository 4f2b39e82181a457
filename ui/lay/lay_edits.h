// Every change of the laid tiles as a named step of the document: what mouse, keys and panel do alike.
#pragma once

#include <QCoreApplication>
#include <QString>
#include <string>
#include <unordered_set>
#include <vector>

#include "floor/serial_rule.h"
#include "ui/base/site_document.h"
#include "ui/lay/tile_snap.h"

namespace tessera::ui {

/// By serial number.
using TileSet = std::unordered_set<std::string>;

struct NewTile {
  std::string type;
  Point low;  ///< lower left corner of the floor that it covers
  int quarterTurns = 0;
};

/// Steps that fail (one tile upon another, a serial number that is taken) change nothing and say why.
class LayEdits {
  Q_DECLARE_TR_FUNCTIONS(LayEdits)
public:
  enum class Line { Left, Right, Bottom, Top, Lattice };
  static constexpr std::size_t kMostTiles = 1'000'000;  ///< that a site file may hold
  static constexpr int kLongestSerial = 200;

  explicit LayEdits(SiteDocument& document) : document_{document} {}

  /// Nullptr: no type of that name.
  [[nodiscard]] const floor::TileType* type(const std::string& name) const;

  /// The new tiles' serial numbers, by the rule. `types` come along where the site does not know them yet.
  Result<TileSet> lay(const QString& step, const std::vector<NewTile>& tiles, const floor::SerialRule& rule,
                      const std::vector<floor::TileType>& types = {});
  /// mergeKey: see SiteDocument::edit.
  Result<void> move(const TileSet& tiles, Offset by, int mergeKey = 0);
  /// A quarter counter-clockwise, all of them about their common middle; four times are none.
  Result<void> turn(const TileSet& tiles);
  /// Each about its own middle.
  Result<void> turnEach(const TileSet& tiles);
  Result<void> align(const TileSet& tiles, Line line);
  Result<void> place(const std::string& serial, Point low, int quarterTurns, int mergeKey = 0);
  Result<void> remove(const TileSet& tiles);
  /// Error: a serial number that is empty, too long or taken.
  Result<void> rename(const std::string& serial, const QString& to);

private:
  struct Laid {
    std::size_t placement;
    const floor::TileType* type;
    Box box;
  };
  // Of laid()[index] to another place.
  struct Move {
    std::size_t index;
    Point low;
    int turns;
    Offset size;  ///< as turned
  };
  using Moves = std::vector<Move>;
  [[nodiscard]] std::vector<Laid> laid() const;
  [[nodiscard]] Moves movesOf(const std::vector<Laid>& laid, const TileSet& tiles) const;
  Result<void> rearrange(const QString& step, const std::vector<Laid>& laid, const Moves& moves, int mergeKey = 0);

  SiteDocument& document_;
};

}  // namespace tessera::ui
