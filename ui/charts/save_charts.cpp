// Saving live charts: pictures in print colours, values for a spreadsheet.
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>
#include <QStandardPaths>
#include <QTextStream>
#include <cmath>

#include "floor/text_file.h"
#include "ui/base/wording.h"
#include "ui/charts/live_charts.h"
#include "ui/charts/time_chart.h"
#include "ui/charts/track_chart.h"

namespace tessera::ui {
namespace {

constexpr double kPictureScale = 2.0;
constexpr int kPrintWidth = 1100;  // in the charts' own pixels
constexpr int kPrintHeight = 560;
constexpr double kTrackShare = 0.42;

QPalette printPalette() {
  QPalette light{QColor{0xF0, 0xF0, 0xF0}};
  light.setColor(QPalette::Base, Qt::white);
  light.setColor(QPalette::Text, Qt::black);
  return light;
}

}  // namespace

QString LiveCharts::saveTo(const QString& file) {
  if (const auto fit = floor::replaceable(file.toStdString()); !fit) return text(fit.error().sentence);
  return QFileInfo{file}.suffix().compare(QLatin1String("csv"), Qt::CaseInsensitive) == 0 ? writeValues(file)
                                                                                          : writePicture(file);
}

QString LiveCharts::writePicture(const QString& file) {
  const QString failed = tr("The picture %1 could not be written. Choose another folder.").arg(file);
  const int trackWidth = static_cast<int>(kPrintWidth * kTrackShare);
  const int timeWidth = kPrintWidth - trackWidth;
  dressCharts(printPalette());
  track_->layOutFor({trackWidth, kPrintHeight});
  bool written = false;
  if (QFileInfo{file}.suffix().compare(QLatin1String("pdf"), Qt::CaseInsensitive) == 0) {
    QPdfWriter pdf{file};
    pdf.setTitle(tr("%1: track, cross-track error and speed").arg(name()));
    pdf.setResolution(96);
    pdf.setPageSize(
        QPageSize{QSizeF{kPrintWidth * 0.75, kPrintHeight * 0.75}, QPageSize::Point, {}, QPageSize::ExactMatch});
    pdf.setPageMargins({});
    QCPPainter painter;
    if (painter.begin(&pdf)) {
      painter.setMode(QCPPainter::pmVectorized);
      track_->toPainter(&painter, trackWidth, kPrintHeight);
      painter.translate(trackWidth, 0);
      time_->toPainter(&painter, timeWidth, kPrintHeight);
      written = painter.end();
    }
  } else {
    QPixmap picture{QSize{kPrintWidth, kPrintHeight} * kPictureScale};
    picture.fill(Qt::white);
    QPainter painter{&picture};
    painter.drawPixmap(0, 0, track_->toPixmap(trackWidth, kPrintHeight, kPictureScale));
    painter.drawPixmap(static_cast<int>(trackWidth * kPictureScale), 0,
                       time_->toPixmap(timeWidth, kPrintHeight, kPictureScale));
    painter.end();
    written = picture.save(file, "PNG");
  }
  dressCharts(palette());
  track_->layOutFor(track_->size());
  draw();
  return written ? QString{} : failed;
}

// Decimal points and commas whatever the language: programs read this.
QString LiveCharts::writeValues(const QString& file) const {
  QSaveFile out{file};
  if (!out.open(QIODevice::WriteOnly | QIODevice::Text))
    return tr("The file %1 could not be written. Choose another folder.").arg(file);
  QTextStream text{&out};
  text << "time_s,x_m,y_m,heading_deg,cross_track_m,speed_mps,commanded_mps\n";
  const auto cell = [](double value, int decimals) {
    return std::isnan(value) ? QString{} : QString::number(value, 'f', decimals);
  };
  for (const DriveSample& s : samples()) {
    text << cell(s.time, 3);
    for (const float value : {s.x, s.y}) text << ',' << cell(static_cast<double>(value), 4);
    text << ',' << cell(static_cast<double>(s.heading) * 180.0 / M_PI, 2);
    for (const float value : {s.crossTrack, s.speed, s.commanded}) text << ',' << cell(static_cast<double>(value), 4);
    text << '\n';
  }
  text.flush();
  return out.commit() ? QString{} : tr("The file %1 could not be written. Choose another folder.").arg(file);
}

void LiveCharts::askAndSave() {
  QFileDialog dialog{this, tr("Save the charts"), QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)};
  dialog.setObjectName(QStringLiteral("saveChartsDialog"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  // Qt's own dialogue: keys pressed in a foreign one would not reach Stop all.
  dialog.setOption(QFileDialog::DontUseNativeDialog);
  const QStringList kinds{tr("Picture (*.png)"), tr("Document (*.pdf)"), tr("Values (*.csv)")};
  dialog.setNameFilters(kinds);
  dialog.selectFile(name());
  const auto suffix = [&] {
    const auto kind = kinds.indexOf(dialog.selectedNameFilter());
    dialog.setDefaultSuffix(kind == 1   ? QStringLiteral("pdf")
                            : kind == 2 ? QStringLiteral("csv")
                                        : QStringLiteral("png"));
  };
  connect(&dialog, &QFileDialog::filterSelected, &dialog, suffix);
  suffix();
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
  const QString failed = saveTo(dialog.selectedFiles().front());
  if (!failed.isEmpty()) QMessageBox::warning(this, tr("Save the charts"), failed);
}

}  // namespace tessera::ui
