#include "ui/charts/plot_look.h"

namespace tessera::ui {

PlotColours::PlotColours(const QPalette& palette)
    : back{palette.color(QPalette::Base)}, ink{palette.color(QPalette::Text)} {
  const bool dark = back.lightness() < 128;
  const auto pick = [dark](QRgb light, QRgb night) { return QColor::fromRgb(dark ? night : light); };
  grid = pick(0xDDE1E6, 0x3A4047);
  route = pick(0x9FB0C4, 0x5C6D82);
  commanded = pick(0xB3611A, 0xF0A35E);
  band = pick(0x17713F, 0x55C98A);
}

void dressAxes(QCPAxisRect& axes, const PlotColours& colours, const QFont& font) {
  for (QCPAxis* axis : axes.axes()) {
    axis->setBasePen(QPen{colours.grid, 1});
    axis->setTickPen(QPen{colours.grid, 1});
    axis->setSubTickPen(Qt::NoPen);
    axis->setTickLabelColor(colours.ink);
    axis->setLabelColor(colours.ink);
    axis->setTickLabelFont(font);
    axis->setLabelFont(font);
    axis->grid()->setPen(QPen{colours.grid, 1});
    axis->grid()->setZeroLinePen(QPen{colours.grid.darker(120), 1});
  }
}

void dressLegend(QCPLegend& legend, const PlotColours& colours, const QFont& font) {
  legend.setFont(font);
  legend.setTextColor(colours.ink);
  legend.setBorderPen(Qt::NoPen);
  legend.setBrush(Qt::NoBrush);
  for (int i = 0; i < legend.itemCount(); ++i) {
    legend.item(i)->setFont(font);  // each keeps its own
    legend.item(i)->setTextColor(colours.ink);
  }
}

void layFlat(QCPLegend& legend) {
  legend.setFillOrder(QCPLegend::foColumnsFirst);
  legend.setWrap(8);
  legend.setMargins(QMargins{2, 2, 2, 2});
}

void layLegendAbove(QCustomPlot& plot) {
  QCPLayoutGrid& rows = *plot.plotLayout();
  rows.insertRow(0);
  auto* above = new QCPLayoutGrid;
  rows.addElement(0, 0, above);
  above->addElement(0, 0, plot.legend);
  above->addElement(0, 1, new QCPLayoutElement);  // takes what the legend does not need
  above->setColumnStretchFactor(0, 0.001);
  rows.setRowStretchFactor(0, 0.001);
  plot.legend->setVisible(true);
  layFlat(*plot.legend);
}

}  // namespace tessera::ui
