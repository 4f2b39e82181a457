// What all pictures of experiments share: colours, title, a legend below the axes, writing the file.
#pragma once

#include <QColor>
#include <QString>
#include <string>

#include "base/result.h"

class QCustomPlot;
class QCPLayoutGrid;

namespace tessera::ui {

inline constexpr int kChartWidth = 900;          ///< pixels of every picture
inline constexpr std::size_t kChartColours = 8;  ///< series that are told apart by colour alone

/// Stays apart from the others for colour-blind readers, on white; from the beginning again after kChartColours.
[[nodiscard]] QColor chartColour(std::size_t series);

/// A row above all that the plot holds so far.
void addChartTitle(QCustomPlot& plot, const std::string& title);

/// The plot's legend in a row below all that it holds so far, where it hides nothing; `columns` entries side by side.
void putLegendBelow(QCustomPlot& plot, int columns);

/// Error: names the file that could not be written.
[[nodiscard]] Result<void> saveChart(QCustomPlot& plot, const QString& file, int height);

}  // namespace tessera::ui
