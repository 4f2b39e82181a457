#include "ui/backdrop/backdrop_panel.h"

#include <QDoubleSpinBox>
#include <QEvent>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSlider>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <cmath>

#include "ui/base/wording.h"

namespace tessera::ui {
namespace {

constexpr int kFirstPlanValueKey = 42'000'000;  // apart from those of other panels
constexpr double kMillimetres = 1000.0;         // in a metre

}  // namespace

BackdropPanel::BackdropPanel(SiteDocument& document, BackdropTool& tool, QWidget* parent)
    : QWidget{parent}, document_{document}, tool_{tool}, edits_{document}, valueKey_{kFirstPlanValueKey} {
  setObjectName("backdropPanel");
  pages_ = new QStackedWidget;
  pages_->addWidget(makeEmptyPage());
  pages_->addWidget(makePicturePage());
  auto* layout = new QVBoxLayout{this};
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(pages_);
  connect(&document_, &SiteDocument::changed, this, &BackdropPanel::refresh);
  connect(&tool_, &CanvasTool::changed, this, &BackdropPanel::refreshScaling);
  connect(&tool_, &BackdropTool::refused, this, &BackdropPanel::refuse);
  connect(&tool_, &BackdropTool::distanceWanted, this, [this] {
    filling_ = true;
    distance_->setValue(tool_.between().value_or(Metres{}).value());
    filling_ = false;
    distance_->setFocus();
    distance_->selectAll();
  });
  retranslate();
  refresh();
}

// A field that has the focus finishes its editing while the window goes, when this is a panel no more.
BackdropPanel::~BackdropPanel() {
  for (QDoubleSpinBox* box : numbers_) box->disconnect(this);
}

void BackdropPanel::refresh() {
  const floor::Backdrop* backdrop = edits_.find();
  pages_->setCurrentIndex(backdrop != nullptr ? 1 : 0);
  picture_ = backdrop != nullptr ? BackdropPicture::of(backdrop->picture) : nullptr;
  refreshScaling();
  if (backdrop == nullptr) return;
  filling_ = true;
  name_->setText(QString::fromStdString(backdrop->file));
  const QLocale locale;
  const QSize pixels = picture_->size();
  const auto metres = [&](int n) { return locale.toString((n * backdrop->pixel).value(), 'f', 2); };
  size_->setText(picture_->fault() ? text(*picture_->fault())
                                   : tr("%1 × %2 pixels, %3 × %4 m")
                                         .arg(locale.toString(pixels.width()), locale.toString(pixels.height()),
                                              metres(pixels.width()), metres(pixels.height())));
  opacity_->setValue(static_cast<int>(std::lround(backdrop->opacity * 100.0)));
  opacityText_->setText(tr("%1 %", "opacity").arg(locale.toString(opacity_->value())));
  numbers_[kX]->setValue(backdrop->origin.x.value());
  numbers_[kY]->setValue(backdrop->origin.y.value());
  numbers_[kTurn]->setValue(degrees(backdrop->turn));
  numbers_[kPixel]->setValue(backdrop->pixel.value() * kMillimetres);
  scale_->setEnabled(!picture_->fault());
  filling_ = false;
}

void BackdropPanel::refreshScaling() {
  const bool scaling = tool_.isScaling();
  const bool ready = tool_.points().size() == 2;
  scale_->setVisible(!scaling);
  scaling_->setVisible(scaling);
  distance_->setEnabled(ready);
  apply_->setEnabled(ready);
  scalingText_->setText(tool_.points().empty()       ? tr("Click a point of the picture on the floor.")
                        : tool_.points().size() == 1 ? tr("Click a second point, far from the first.")
                                                     : tr("How far are the two points truly apart?"));
}

void BackdropPanel::changed(Number which, double value) {
  const floor::Backdrop* backdrop = edits_.find();
  if (filling_ || backdrop == nullptr) return;
  const int key = valueKey_ + which;
  switch (which) {
    case kX:
      return tell(edits_.move({Metres{value}, backdrop->origin.y}, key));
    case kY:
      return tell(edits_.move({backdrop->origin.x, Metres{value}}, key));
    case kTurn:
      return tell(edits_.turn(fromDegrees(value), key));
    default:
      return tell(edits_.setPixel(Metres{value / kMillimetres}, key));
  }
}

void BackdropPanel::applyDistance() {
  if (tool_.points().size() != 2) return;
  distance_->interpretText();
  const auto done = tool_.finishScaling(Metres{distance_->value()});
  tell(done);
  if (done) Q_EMIT scalingEnded();
}

void BackdropPanel::giveScalingUp() {
  tool_.cancel();
  Q_EMIT scalingEnded();
}

void BackdropPanel::refuse(const Error& why) {
  Q_EMIT refused(text(why.sentence));
  refresh();
}

void BackdropPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange) {
    retranslate();
    refresh();
  }
  QWidget::changeEvent(event);
}

}  // namespace tessera::ui
