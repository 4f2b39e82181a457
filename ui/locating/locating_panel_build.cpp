// The panel's widgets and their words.
#include <QEvent>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QVBoxLayout>

#include "ui/base/icon.h"
#include "ui/base/vehicle_colour.h"
#include "ui/locating/locating_panel.h"

namespace tessera::ui {
namespace {

constexpr std::array kRowNames{"Place",  "Doubt",     "Fit",   "Error", "Contradicted", "Reads",
                               "Report", "Predicted", "Delay", "Aim",   "Locator"};

}  // namespace

void LocatingPanel::build() {
  name_ = new QLabel{this};
  name_->setObjectName(QStringLiteral("locatedVehicle"));
  name_->setTextFormat(Qt::PlainText);
  shape_ = new QComboBox{this};
  shape_->setObjectName(QStringLiteral("doubtShape"));
  for (int i = 0; i < 3; ++i) shape_->addItem(QString{});
  shape_->setCurrentIndex(static_cast<int>(overlay_.shape()));
  reset_ = new QPushButton{icon(QStringLiteral("clear")), QString{}, this};
  reset_->setObjectName(QStringLiteral("resetLocating"));
  auto* bar = new QHBoxLayout;
  bar->addWidget(name_, 1);
  bar->addWidget(shape_);
  bar->addWidget(reset_);

  auto* content = new QWidget;
  // The content's own layout and not one within another: the scroll area asks for the new height of a text that wraps
  // anew before layouts within are told that it has changed.
  auto* form = new QFormLayout{content};
  form->setContentsMargins(0, 0, 0, 0);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  for (std::size_t i = 0; i < Rows; ++i) {
    names_[i] = new QLabel{content};
    values_[i] = new QLabel{content};
    values_[i]->setObjectName(QStringLiteral("locating") + QLatin1String{kRowNames[i]});
    values_[i]->setTextFormat(Qt::PlainText);
    values_[i]->setWordWrap(true);
    values_[i]->setTextInteractionFlags(Qt::TextSelectableByMouse);
    form->addRow(names_[i], values_[i]);
  }
  form->addItem(new QSpacerItem{0, 0, QSizePolicy::Minimum, QSizePolicy::Expanding});
  auto* scroll = new QScrollArea;
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(content);
  auto* both = new QWidget{this};
  chart_ = new InnovationChart{both};
  sides_ = new QBoxLayout{QBoxLayout::TopToBottom, both};
  sides_->setContentsMargins(0, 0, 0, 0);
  sides_->addWidget(scroll, 1);
  sides_->addWidget(chart_, 1);

  hint_ = new QLabel{this};
  hint_->setObjectName(QStringLiteral("locatingHint"));
  hint_->setAlignment(Qt::AlignCenter);
  hint_->setWordWrap(true);
  hint_->setTextFormat(Qt::PlainText);
  auto* below = new QWidget{this};
  pages_ = new QStackedLayout{below};
  pages_->addWidget(hint_);
  pages_->addWidget(both);
  auto* all = new QVBoxLayout{this};
  all->addLayout(bar);
  all->addWidget(below, 1);

  connect(shape_, &QComboBox::currentIndexChanged, this, [this](int index) {
    overlay_.setShape(static_cast<DoubtShape>(index));
    Q_EMIT overlayChanged();
  });
  connect(reset_, &QPushButton::clicked, this, [this] {
    record_.clear();
    refresh();
  });
}

void LocatingPanel::retranslate() {
  setWindowTitle(tr("Locating"));
  shape_->setItemText(0, tr("Guesses"));
  shape_->setItemText(1, tr("Ellipse (95 %)"));
  shape_->setItemText(2, tr("Guesses and ellipse"));
  shape_->setAccessibleName(tr("What is drawn of the doubt"));
  shape_->setToolTip(
      tr("What is drawn of the doubt upon the floor: places thought possible, or the ellipse that holds "
         "the vehicle in 95 of 100 cases."));
  reset_->setToolTip(tr("Forget the reads and errors so far and count anew"));
  reset_->setAccessibleName(tr("Count anew"));
  const std::array texts{tr("Place"),          tr("Doubt (1 σ)"),    tr("Fit of the reads"), tr("Error (simulation)"),
                         tr("Contradictions"), tr("Last reads"),     tr("Last report"),      tr("Predicted"),
                         tr("Delay"),          tr("Looks ahead to"), tr("Locator")};
  static_assert(kRowNames.size() == Rows && texts.size() == Rows);
  for (std::size_t i = 0; i < Rows; ++i) names_[i]->setText(texts[i]);
  chart_->retranslate();
  refresh();
}

// Chart and numbers side by side where the panel lies low, else one above the other.
void LocatingPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  sides_->setDirection(width() > height() ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
}

void LocatingPanel::dress() {
  chart_->dress(palette(), font(),
                vehicleColour(document_.site(), selection_.vehicle().value_or(VehicleId{0}), palette()));
}

void LocatingPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange) {
    chart_->setLocale(QLocale{});
    retranslate();
  }
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) dress();
  QWidget::changeEvent(event);
}

}  // namespace tessera::ui
