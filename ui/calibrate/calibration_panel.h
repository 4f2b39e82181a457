// What the panels of the calibration have in common: two sides beside or above each other, a vehicle's name and a hint
// on the first, and looking again when something that they show may have changed.
#pragma once

#include <QBoxLayout>
#include <QLabel>
#include <QWidget>

#include "ui/base/fleet_link.h"
#include "ui/base/selection.h"
#include "ui/base/site_document.h"
#include "ui/base/throttle.h"

namespace tessera::ui {

class CalibrationPanel : public QWidget {
protected:
  /// All must outlive it.
  CalibrationPanel(FleetLink& fleet, Selection& selection, SiteDocument& document, QWidget* parent);
  /// At the end of the panel's own constructor: listens to its work as well, and shows its texts.
  template <class Work>
  void begin(Work& work) {
    connect(&work, &Work::changed, this, [this] { refresh(); });
    listen();
    retranslate();
  }
  virtual void retranslate() = 0;
  virtual void refresh() = 0;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

  FleetLink& fleet_;
  Selection& selection_;
  SiteDocument& document_;
  QBoxLayout* sides_ = nullptr;
  QLabel* name_ = nullptr;
  QLabel* hint_ = nullptr;

private:
  void listen();

  Throttle throttle_;
};

}  // namespace tessera::ui
