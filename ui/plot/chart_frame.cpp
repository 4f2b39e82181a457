#include "ui/plot/chart_frame.h"

#include <qcustomplot.h>

#include <array>

namespace tessera::ui {

QColor chartColour(std::size_t series) {
  // Okabe and Ito, 2008; their yellow, which is faint on white, is darkened.
  static const std::array<QColor, kChartColours> colours{
      QColor{0, 114, 178},  QColor{213, 94, 0}, QColor{0, 158, 115}, QColor{204, 121, 167},
      QColor{86, 180, 233}, QColor{0, 0, 0},    QColor{230, 159, 0}, QColor{140, 130, 20}};
  return colours[series % colours.size()];
}

void addChartTitle(QCustomPlot& plot, const std::string& title) {
  plot.plotLayout()->setMargins(QMargins{8, 8, 8, 4});
  plot.plotLayout()->insertRow(0);
  plot.plotLayout()->addElement(
      0, 0, new QCPTextElement{&plot, QString::fromStdString(title), QFont{QStringLiteral("DejaVu Sans"), 11}});
}

void putLegendBelow(QCustomPlot& plot, int columns) {
  const int row = plot.plotLayout()->rowCount();
  auto* below = new QCPLayoutGrid;  // owned by the plot, as all elements
  plot.plotLayout()->addElement(row, 0, below);
  below->addElement(0, 0, plot.legend);
  plot.legend->setVisible(true);
  plot.legend->setWrap(columns);
  plot.legend->setFillOrder(QCPLegend::foColumnsFirst);  // and lays out anew what it holds
  plot.legend->setBorderPen(Qt::NoPen);
  plot.plotLayout()->setRowStretchFactor(row, 0.001);
}

Result<void> saveChart(QCustomPlot& plot, const QString& file, int height) {
  if (!plot.savePng(file, kChartWidth, height))
    return failure("The picture " + file.toStdString() + " could not be written.");
  return {};
}

}  // namespace tessera::ui
