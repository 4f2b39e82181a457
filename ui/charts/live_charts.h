// Live charts of the chosen vehicle: track against route to scale, cross-track error, speed. They can be held still,
// looked at closely and saved.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QSplitter>
#include <QStackedLayout>
#include <QToolButton>
#include <QWidget>
#include <optional>
#include <string>
#include <vector>

#include "ui/base/fleet_link.h"
#include "ui/base/selection.h"
#include "ui/base/site_document.h"
#include "ui/base/throttle.h"
#include "ui/charts/drive_samples.h"

namespace tessera::ui {

class TimeChart;
class TrackChart;

class LiveCharts : public QWidget {
  Q_OBJECT
public:
  LiveCharts(FleetLink& link, Selection& selection, SiteDocument& document, QWidget* parent = nullptr);

  /// Writes what is shown: a picture (.png, .pdf) or the values (.csv). Empty, or a sentence that says what failed.
  [[nodiscard]] QString saveTo(const QString& file);
  /// The samples on show, oldest first.
  [[nodiscard]] std::vector<DriveSample> samples() const;

protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

private:
  void build();
  QToolButton* makeButton(const QString& name, const QString& iconName);
  void retranslate();
  void dress();
  void dressCharts(const QPalette& palette);
  void takeVehicle();
  void draw();
  void showRoute();
  void hold(bool still);
  void clear();
  void askAndSave();
  [[nodiscard]] QString writePicture(const QString& file);
  [[nodiscard]] QString writeValues(const QString& file) const;
  [[nodiscard]] double span() const;
  [[nodiscard]] QString name() const;
  /// What the operator does next, while there is nothing to draw.
  [[nodiscard]] QString whatNow() const;

  FleetLink& link_;
  Selection& selection_;
  SiteDocument& document_;
  DriveSamples samples_;
  double until_ = 0.0;  ///< right end of what is shown, s
  bool still_ = false;
  bool arranged_ = false;
  std::optional<std::string> shownRoute_;  ///< name; none yet: to be looked up
  QLabel* dot_ = nullptr;
  QLabel* name_ = nullptr;
  QComboBox* window_ = nullptr;
  QToolButton* holdButton_ = nullptr;
  QToolButton* clear_ = nullptr;
  QToolButton* save_ = nullptr;
  QLabel* hint_ = nullptr;
  QSplitter* charts_ = nullptr;
  QStackedLayout* pages_ = nullptr;
  TrackChart* track_ = nullptr;
  TimeChart* time_ = nullptr;
  Throttle throttle_;
};

}  // namespace tessera::ui
