// How the chosen vehicle is located: numbers, the innovations of its reads, errors where the truth is known, and what
// the overlay draws upon the floor. While it is seen, the supervision tells of that vehicle in detail.
#pragma once

#include <QBoxLayout>
#include <QComboBox>
#include <QElapsedTimer>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedLayout>
#include <QTimer>
#include <QWidget>
#include <array>

#include "ui/base/fleet_link.h"
#include "ui/base/selection.h"
#include "ui/base/site_document.h"
#include "ui/base/throttle.h"
#include "ui/locating/innovation_chart.h"
#include "ui/locating/locating_overlay.h"
#include "ui/locating/locating_record.h"

namespace tessera::ui {

class LocatingPanel : public QWidget {
  Q_OBJECT
public:
  /// All must outlive it.
  LocatingPanel(FleetLink& fleet, Selection& selection, SiteDocument& document, TruthSource& truth,
                QWidget* parent = nullptr);

  [[nodiscard]] LocatingOverlay& overlay() { return overlay_; }
  [[nodiscard]] const LocatingRecord& record() const { return record_; }

Q_SIGNALS:
  /// The overlay shows something else, or nothing.
  void overlayChanged();

protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  /// What is judged by comes first: in a low window the list goes on below the edge.
  enum Row { Place, Doubt, Fit, Error, Contradicted, Reads, Report, Predicted, Delay, Aim, Locator, Rows };

  void build();
  void retranslate();
  void dress();
  void take();
  void askToWatch();
  void askTruth();
  void refresh();
  void showNumbers(const supervisor::LocatingView& view, const supervisor::VehicleView& vehicle, Seconds now);
  void showStatistics();
  [[nodiscard]] QString whatNow() const;
  [[nodiscard]] QString name() const;
  void set(Row row, const QString& text);

  FleetLink& fleet_;
  Selection& selection_;
  SiteDocument& document_;
  TruthSource& truth_;
  LocatingRecord record_;
  LocatingOverlay overlay_;
  std::shared_ptr<const supervisor::Snapshot> shown_;  ///< with a watched vehicle that is the chosen one; or null
  QElapsedTimer asked_;
  QTimer truthTimer_;
  QLabel* name_ = nullptr;
  QComboBox* shape_ = nullptr;
  QPushButton* reset_ = nullptr;
  QLabel* hint_ = nullptr;
  QStackedLayout* pages_ = nullptr;
  QBoxLayout* sides_ = nullptr;
  std::array<QLabel*, Rows> names_{};
  std::array<QLabel*, Rows> values_{};
  InnovationChart* chart_ = nullptr;
  Throttle throttle_;
};

}  // namespace tessera::ui
