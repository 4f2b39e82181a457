#include "ui/print/map_picture_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDate>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

namespace tessera::ui {
namespace {

constexpr double kScales[] = {5, 10, 20, 25, 50, 100, 200, 500, 1000, 2000};
constexpr QSizeF kA3{420.0, 297.0};
constexpr std::size_t kMostShown = 50'000;

// The largest usual scale with which the sheet fits a page of A3, either way.
double fittingScale(const std::shared_ptr<const floor::SiteMap>& map, bool plan) {
  for (const double scale : kScales) {
    SheetWish wish;
    wish.plan = plan;
    wish.scale = scale;
    const QSizeF mm = MapSheet{map, wish}.millimetres();
    if ((mm.width() <= kA3.width() && mm.height() <= kA3.height()) ||
        (mm.height() <= kA3.width() && mm.width() <= kA3.height()))
      return scale;
  }
  return std::end(kScales)[-1];
}

}  // namespace

MapPictureDialog::MapPictureDialog(std::shared_ptr<const floor::SiteMap> map, bool planShown, QWidget* parent)
    : QDialog{parent}, map_{std::move(map)} {
  setObjectName(QStringLiteral("mapPictureDialog"));
  setProperty("helpTopic", QStringLiteral("exchange"));
  setWindowTitle(tr("Picture of the map"));
  scale_ = new QComboBox;
  scale_->setObjectName(QStringLiteral("pictureScale"));
  const bool hasPlan = map_->site().backdrop.has_value();
  const double fitting = fittingScale(map_, hasPlan && planShown);
  for (const double scale : kScales) {
    scale_->addItem(tr("1 : %1").arg(QLocale().toString(scale, 'g', 6)), scale);
    if (scale == fitting) scale_->setCurrentIndex(scale_->count() - 1);
  }
  const auto box = [this](const QString& text, const char* name) {
    auto* check = new QCheckBox{text};
    check->setObjectName(QString::fromLatin1(name));
    check->setChecked(true);
    return check;
  };
  tags_ = box(tr("&Tags"), "pictureTags");
  serials_ = box(tr("Serial &numbers"), "pictureSerials");
  zones_ = box(tr("&Zones"), "pictureZones");
  routes_ = box(tr("&Routes"), "pictureRoutes");
  legend_ = box(tr("&Legend"), "pictureLegend");
  plan_ = box(tr("Floor &plan"), "picturePlan");
  plan_->setEnabled(hasPlan);
  plan_->setChecked(hasPlan && planShown);
  size_ = new QLabel;
  size_->setObjectName(QStringLiteral("pictureSize"));
  picture_ = new QLabel;
  picture_->setAlignment(Qt::AlignCenter);
  picture_->setMinimumSize(240, 180);
  picture_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
  auto* form = new QFormLayout;
  form->addRow(tr("&Scale:"), scale_);
  form->addRow(tr("Paper:"), size_);
  for (QCheckBox* check : {tags_, serials_, zones_, routes_, plan_, legend_}) {
    form->addRow(QString{}, check);
    connect(check, &QCheckBox::toggled, this, &MapPictureDialog::look);
  }
  auto* buttons = new QDialogButtonBox{QDialogButtonBox::Save | QDialogButtonBox::Cancel};
  buttons->button(QDialogButtonBox::Save)->setText(tr("Sa&ve as…"));
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(scale_, &QComboBox::currentIndexChanged, this, &MapPictureDialog::look);
  auto* row = new QHBoxLayout;
  row->addLayout(form);
  row->addWidget(picture_, 1);
  auto* column = new QVBoxLayout{this};
  column->addLayout(row, 1);
  column->addWidget(buttons);
  const int line = fontMetrics().height();
  resize(46 * line, 26 * line);
  look();
}

SheetWish MapPictureDialog::wish() const {
  SheetWish wish;
  wish.scale = scale_->currentData().toDouble();
  wish.tags = tags_->isChecked();
  wish.serials = serials_->isChecked() && serials_->isEnabled();
  wish.zones = zones_->isChecked();
  wish.routes = routes_->isChecked();
  wish.legend = legend_->isChecked();
  wish.plan = plan_->isChecked();
  wish.date = QLocale().toString(QDate::currentDate(), QLocale::ShortFormat);
  return wish;
}

void MapPictureDialog::look() {
  SheetWish shown = wish();
  // At this size the dots of so many tags are one grey, and would take seconds to draw.
  if (shown.tags && map_->tags().size() > kMostShown) shown.tags = shown.serials = false;
  const MapSheet sheet{map_, shown};
  const bool room = sheet.hasRoomForSerials() || map_->site().tiles.empty();
  serials_->setEnabled(room);
  serials_->setText(room ? tr("Serial &numbers") : tr("Serial &numbers (too small at this scale)"));
  const QLocale locale;
  const QSizeF mm = sheet.millimetres();
  size_->setText(
      tr("%1 × %2 cm").arg(locale.toString(mm.width() / 10.0, 'f', 1), locale.toString(mm.height() / 10.0, 'f', 1)));
  const double ratio = devicePixelRatioF();
  const QSizeF place = QSizeF{picture_->size()} * ratio;
  const double shrink = std::min({place.width() / sheet.size().width(), place.height() / sheet.size().height(), ratio});
  QImage image{(sheet.size() * shrink).toSize().expandedTo({1, 1}), QImage::Format_RGB32};
  image.setDotsPerMeterX(3780);  // 96 to the inch, as the sheet reckons
  image.setDotsPerMeterY(3780);
  QPainter painter{&image};
  painter.scale(shrink, shrink);
  sheet.paint(painter);
  painter.end();
  image.setDevicePixelRatio(ratio);
  picture_->setPixmap(QPixmap::fromImage(image));
}

void MapPictureDialog::resizeEvent(QResizeEvent* event) {
  QDialog::resizeEvent(event);
  look();
}

}  // namespace tessera::ui
