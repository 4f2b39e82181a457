// A tile type to scale, with the tiles that would lie beside it: where its tags are and how they go on over the seams.
#pragma once

#include <QWidget>

#include "floor/seam.h"
#include "floor/tile_pattern.h"

namespace tessera::ui {

class TypePicture : public QWidget {
  Q_OBJECT
public:
  explicit TypePicture(QWidget* parent = nullptr);

  void setType(const floor::TileType& type);

  [[nodiscard]] QSize sizeHint() const override { return {300, 300}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {180, 180}; }
  /// Where the place is drawn.
  [[nodiscard]] QPointF pixelOf(int column, int row) const;

Q_SIGNALS:
  /// A click on a place, or the space bar.
  void placeToggled(int column, int row);

protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  [[nodiscard]] double scale() const;
  [[nodiscard]] QPointF toPixel(Offset place) const;
  void retranslate();
  void paintTile(QPainter& painter, Offset corner, bool neighbour) const;

  floor::TileType type_;
  floor::Seam right_;
  floor::Seam above_;
  int column_ = 0;  ///< of the place that the keys are at
  int row_ = 0;
};

}  // namespace tessera::ui
