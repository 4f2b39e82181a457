// How every live chart looks: the window's palette and font, light or dark.
#pragma once

#include <qcustomplot.h>

#include <QFont>
#include <QPalette>

namespace tessera::ui {

struct PlotColours {
  explicit PlotColours(const QPalette& palette);
  QColor back, ink, grid, route, band, commanded;
};

/// Background, axes, grid and legend of one axis rectangle.
void dressAxes(QCPAxisRect& axes, const PlotColours& colours, const QFont& font);
void dressLegend(QCPLegend& legend, const PlotColours& colours, const QFont& font);
/// A legend in one line.
void layFlat(QCPLegend& legend);
/// The plot's own legend in one line above its axes, at the left.
void layLegendAbove(QCustomPlot& plot);

}  // namespace tessera::ui
