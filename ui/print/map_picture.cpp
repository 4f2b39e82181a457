#include "ui/print/map_picture.h"

#include <QImage>
#include <QPageLayout>
#include <QPageSize>
#include <QPdfWriter>
#include <QSaveFile>
#include <QSvgGenerator>
#include <cmath>

#include "floor/text_file.h"

namespace tessera::ui {
namespace {

constexpr double kDotsPerUnit = 150.0 / 96.0;
constexpr int kMostDots = 16'000;
constexpr std::size_t kMostPlaces = 300'000;
constexpr double kMostPdfMm = 5000.0;

Result<void> tooLarge() {
  return failure(phrase("Core", "The picture would be too large. Choose a smaller scale, such as 1 : 200."));
}

Result<void> paintPng(const MapSheet& sheet, QIODevice& device) {
  const QSize dots{static_cast<int>(std::ceil(sheet.size().width() * kDotsPerUnit)),
                   static_cast<int>(std::ceil(sheet.size().height() * kDotsPerUnit))};
  if (dots.width() > kMostDots || dots.height() > kMostDots) return tooLarge();
  QImage image{dots, QImage::Format_RGB32};
  if (image.isNull()) return tooLarge();
  const auto setDensity = [&image](double perInch) {
    image.setDotsPerMeterX(static_cast<int>(std::lround(perInch / 0.0254)));
    image.setDotsPerMeterY(static_cast<int>(std::lround(perInch / 0.0254)));
  };
  image.fill(Qt::white);
  setDensity(96.0);
  QPainter painter{&image};
  painter.scale(kDotsPerUnit, kDotsPerUnit);
  sheet.paint(painter);
  painter.end();
  setDensity(150.0);
  image.save(&device, "PNG");  // an error stays with the device
  return {};
}

void paintSvg(const MapSheet& sheet, QIODevice& device) {
  QSvgGenerator svg;
  svg.setOutputDevice(&device);
  svg.setResolution(96);
  svg.setSize(sheet.size().toSize());
  svg.setViewBox(QRectF{{}, sheet.size()});
  QPainter painter{&svg};
  sheet.paint(painter);
}

Result<void> paintPdf(const MapSheet& sheet, QIODevice& device) {
  const QSizeF mm = sheet.millimetres();
  if (std::max(mm.width(), mm.height()) > kMostPdfMm) return tooLarge();
  QPdfWriter pdf{&device};
  pdf.setResolution(96);
  pdf.setPageSize(QPageSize{mm, QPageSize::Millimeter, {}, QPageSize::ExactMatch});
  pdf.setPageMargins({});
  QPainter painter{&pdf};
  sheet.paint(painter);
  return {};
}

}  // namespace

Result<void> saveSheet(const MapSheet& sheet, const QString& path) {
  const bool png = path.endsWith(QLatin1String{".png"}, Qt::CaseInsensitive);
  const bool svg = path.endsWith(QLatin1String{".svg"}, Qt::CaseInsensitive);
  const bool pdf = path.endsWith(QLatin1String{".pdf"}, Qt::CaseInsensitive);
  if (!png && !svg && !pdf) return failure(phrase("Core", "The name of a picture ends with .png, .svg or .pdf."));
  if (!png && sheet.places() > kMostPlaces)
    return failure(phrase("Core",
                          "So many tags make a file that no program opens quickly. Choose PNG, or leave the "
                          "tags out."));
  if (auto fit = floor::replaceable(path.toStdString()); !fit) return fit;
  QSaveFile file{path};
  const auto cannot = [&] {
    return failure(phrase("Core", "Cannot write %1: %2.").with(path.toStdString(), file.errorString().toStdString()));
  };
  if (!file.open(QIODevice::WriteOnly)) return cannot();
  if (png) {
    if (auto done = paintPng(sheet, file); !done) return done;
  } else if (pdf) {
    if (auto done = paintPdf(sheet, file); !done) return done;
  } else {
    paintSvg(sheet, file);
  }
  if (!file.commit()) return cannot();
  return {};
}

}  // namespace tessera::ui
