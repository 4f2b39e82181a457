// One tile as it lies on the floor, as large as there is room: which of its tags is next, which are registered.
#pragma once

#include <QTimer>
#include <QWidget>
#include <optional>

#include "floor/site.h"

namespace tessera::ui {

class TilePicture : public QWidget {
  Q_OBJECT
public:
  enum class Flash { None, Good, Bad };

  explicit TilePicture(QWidget* parent = nullptr);

  /// tag: the next one of it.
  void setTile(const floor::TileType& type, const floor::Tile& tile, int quarterTurns, std::size_t tag);
  void clear();
  void flash(Flash flash);
  [[nodiscard]] Flash flashing() const { return flash_; }

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  struct Shown {
    floor::TileType type;
    floor::Tile tile;
    int turns = 0;
    std::size_t tag = 0;
  };
  std::optional<Shown> shown_;
  Flash flash_ = Flash::None;
  QTimer flashEnd_;
};

}  // namespace tessera::ui
