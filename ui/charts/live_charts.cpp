#include "ui/charts/live_charts.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "ui/base/icon.h"
#include "ui/base/vehicle_colour.h"
#include "ui/charts/time_chart.h"
#include "ui/charts/track_chart.h"

namespace tessera::ui {
namespace {

constexpr std::array kSpans{30, 60, 300, 900};  // s
constexpr int kUsualSpan = 1;                   // index: one minute
constexpr int kDrawEveryMs = 50;

}  // namespace

LiveCharts::LiveCharts(FleetLink& link, Selection& selection, SiteDocument& document, QWidget* parent)
    : QWidget{parent}, link_{link}, selection_{selection}, document_{document}, throttle_{kDrawEveryMs, [this] {
                                                                                            draw();
                                                                                          }} {
  setObjectName(QStringLiteral("liveCharts"));
  build();
  connect(&link_, &FleetLink::snapshotChanged, this, [this] {
    const auto snapshot = link_.latest();
    if (snapshot) samples_.take(*snapshot);
    if (isVisible() && !still_) throttle_.request();
  });
  connect(&selection_, &Selection::vehicleChanged, this, &LiveCharts::takeVehicle);
  connect(&document_, &SiteDocument::changed, this, [this] {
    shownRoute_.reset();  // its vertices may be others
    takeVehicle();
  });
  connect(&document_, &SiteDocument::replaced, this, [this] { samples_.clear(); });
  retranslate();
  takeVehicle();
}

QToolButton* LiveCharts::makeButton(const QString& name, const QString& iconName) {
  auto* button = new QToolButton{this};
  button->setObjectName(name);
  button->setIcon(icon(iconName));
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::StrongFocus);
  return button;
}

void LiveCharts::build() {
  dot_ = new QLabel{this};
  name_ = new QLabel{this};
  name_->setObjectName(QStringLiteral("chartedVehicle"));
  name_->setTextFormat(Qt::PlainText);
  window_ = new QComboBox{this};
  window_->setObjectName(QStringLiteral("timeWindow"));
  for (const int seconds : kSpans) window_->addItem(QString{}, seconds);
  window_->setCurrentIndex(kUsualSpan);
  connect(window_, &QComboBox::currentIndexChanged, this, &LiveCharts::draw);
  holdButton_ = makeButton(QStringLiteral("holdChartsButton"), QStringLiteral("pause"));
  holdButton_->setCheckable(true);
  connect(holdButton_, &QToolButton::toggled, this, &LiveCharts::hold);
  clear_ = makeButton(QStringLiteral("clearChartsButton"), QStringLiteral("delete"));
  connect(clear_, &QToolButton::clicked, this, &LiveCharts::clear);
  save_ = makeButton(QStringLiteral("saveChartsButton"), QStringLiteral("save"));
  connect(save_, &QToolButton::clicked, this, &LiveCharts::askAndSave);
  auto* bar = new QHBoxLayout;
  bar->addWidget(dot_);
  bar->addWidget(name_, 1);
  bar->addWidget(window_);
  bar->addWidget(holdButton_);
  bar->addWidget(clear_);
  bar->addWidget(save_);

  charts_ = new QSplitter{this};
  track_ = new TrackChart{charts_};
  time_ = new TimeChart{charts_};
  charts_->addWidget(track_);
  charts_->addWidget(time_);
  charts_->setStretchFactor(0, 2);
  charts_->setStretchFactor(1, 3);
  const int line = fontMetrics().height();
  track_->setMinimumSize(12 * line, 8 * line);
  time_->setMinimumSize(14 * line, 12 * line);
  hint_ = new QLabel{this};
  hint_->setObjectName(QStringLiteral("chartsHint"));
  hint_->setAlignment(Qt::AlignCenter);
  hint_->setWordWrap(true);
  hint_->setTextFormat(Qt::PlainText);
  auto* below = new QWidget{this};
  pages_ = new QStackedLayout{below};
  pages_->addWidget(hint_);
  pages_->addWidget(charts_);
  auto* column = new QVBoxLayout{this};
  column->addLayout(bar);
  column->addWidget(below, 1);
}

QString LiveCharts::name() const {
  const auto* vehicle = selection_.vehicle() ? document_.map()->vehicle(*selection_.vehicle()) : nullptr;
  return vehicle == nullptr ? QString{} : QString::fromStdString(vehicle->name);
}

double LiveCharts::span() const { return window_->currentData().toDouble(); }

std::vector<DriveSample> LiveCharts::samples() const {
  if (!selection_.vehicle()) return {};
  return samples_.window(*selection_.vehicle(), until_, span());
}

void LiveCharts::takeVehicle() {
  name_->setText(name());
  dress();
  draw();
}

QString LiveCharts::whatNow() const {
  if (document_.site().vehicles.empty())
    return tr("The site has no vehicle yet. Set one up: Vehicle › Set up a new vehicle.");
  if (name().isEmpty()) return tr("Choose a vehicle in the list or on the floor to see how it drives.");
  if (link_.latest() == nullptr)
    return tr("Nothing is known of %1 yet. Connect to the vehicles (Ctrl+K); its charts begin with its first report.")
        .arg(name());
  return tr("Nothing is known of %1 yet. Its charts begin with its first report.").arg(name());
}

void LiveCharts::draw() {
  if (!still_) until_ = samples_.now();
  const auto shown = samples();
  const bool some = !name().isEmpty() && !shown.empty();
  pages_->setCurrentIndex(some ? 1 : 0);
  for (QToolButton* button : {holdButton_, clear_, save_}) button->setEnabled(some || button->isChecked());
  if (!some) {
    hint_->setText(whatNow());
    return;
  }
  if (!isVisible()) return;
  showRoute();
  track_->setTrack(shown);
  time_->setSamples(shown, until_, span());
  track_->replot(QCustomPlot::rpQueuedReplot);
  time_->replot(QCustomPlot::rpQueuedReplot);
}

// The route that it drives, else the one that the operator looks at.
void LiveCharts::showRoute() {
  const auto snapshot = link_.latest();
  const auto* view = snapshot && selection_.vehicle() ? snapshot->find(*selection_.vehicle()) : nullptr;
  const std::string wanted = view != nullptr && !view->route.empty() ? view->route : selection_.route().toStdString();
  if (shownRoute_ == wanted) return;
  shownRoute_ = wanted;
  const floor::Route* route = document_.map()->route(wanted);
  if (route == nullptr) return track_->setRoute({}, {});
  track_->setRoute(QString::fromStdString(route->name), route->vertices);
}

void LiveCharts::hold(bool still) {
  still_ = still;
  holdButton_->setIcon(icon(still ? QStringLiteral("resume") : QStringLiteral("pause")));
  track_->setByHand(still);
  time_->setByHand(still);
  retranslate();
}

void LiveCharts::clear() {
  if (selection_.vehicle()) samples_.clear(*selection_.vehicle());
  holdButton_->setChecked(false);
  draw();
}

void LiveCharts::dressCharts(const QPalette& palette) {
  const QColor vehicle = vehicleColour(document_.site(), selection_.vehicle().value_or(VehicleId{0}), palette);
  track_->dress(palette, font(), vehicle);
  time_->dress(palette, font(), vehicle);
}

void LiveCharts::dress() {
  dressCharts(palette());
  const int side = fontMetrics().height();
  QPixmap disc{QSize{side, side} * devicePixelRatioF()};
  disc.setDevicePixelRatio(devicePixelRatioF());
  disc.fill(Qt::transparent);
  if (!name().isEmpty()) {
    QPainter painter{&disc};
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(vehicleColour(document_.site(), *selection_.vehicle(), palette()));
    painter.drawEllipse(QRectF{side * 0.2, side * 0.2, side * 0.6, side * 0.6});
  }
  dot_->setPixmap(disc);
}

void LiveCharts::retranslate() {
  for (int i = 0; i < window_->count(); ++i) {
    const int seconds = window_->itemData(i).toInt();
    window_->setItemText(i, seconds < 60 ? tr("%1 s").arg(seconds) : tr("%1 min").arg(seconds / 60));
  }
  window_->setToolTip(tr("How far back the charts reach."));
  window_->setAccessibleName(tr("Time shown"));
  holdButton_->setToolTip(still_ ? tr("Let the charts go on.")
                                 : tr("Hold the charts still, to drag and zoom them. Recording goes on."));
  holdButton_->setAccessibleName(still_ ? tr("Go on") : tr("Hold"));
  clear_->setToolTip(tr("Forget what was recorded of this vehicle and begin anew."));
  clear_->setAccessibleName(tr("Clear"));
  save_->setToolTip(tr("Save the charts as a picture (PNG, PDF) or their values (CSV)."));
  save_->setAccessibleName(tr("Save"));
  track_->retranslate();
  time_->retranslate();
  draw();
}

void LiveCharts::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange) {
    track_->setLocale(QLocale{});
    time_->setLocale(QLocale{});
    retranslate();
  }
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) takeVehicle();
  QWidget::changeEvent(event);
}

void LiveCharts::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  draw();
}

void LiveCharts::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const Qt::Orientation wanted = width() > height() ? Qt::Horizontal : Qt::Vertical;
  if (arranged_ && charts_->orientation() == wanted) return;
  arranged_ = true;
  charts_->setOrientation(wanted);
  const int all = wanted == Qt::Horizontal ? width() : height();
  charts_->setSizes({all * 9 / 20, all * 11 / 20});
}

}  // namespace tessera::ui
