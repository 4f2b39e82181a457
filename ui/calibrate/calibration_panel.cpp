#include "ui/calibrate/calibration_panel.h"

#include <QEvent>

namespace tessera::ui {
namespace {

constexpr int kRefreshEveryMs = 200;

}  // namespace

CalibrationPanel::CalibrationPanel(FleetLink& fleet, Selection& selection, SiteDocument& document, QWidget* parent)
    : QWidget{parent},
      fleet_{fleet},
      selection_{selection},
      document_{document},
      sides_{new QBoxLayout{QBoxLayout::TopToBottom, this}},
      throttle_{kRefreshEveryMs, [this] { refresh(); }} {}

void CalibrationPanel::listen() {
  connect(&fleet_, &FleetLink::snapshotChanged, this, [this] {
    if (isVisible()) throttle_.request();
  });
  connect(&selection_, &Selection::vehicleChanged, this, [this] { refresh(); });
  connect(&document_, &SiteDocument::changed, this, [this] { refresh(); });
}

void CalibrationPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  sides_->setDirection(width() > height() ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
}

void CalibrationPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange) retranslate();
  QWidget::changeEvent(event);
}

}  // namespace tessera::ui
