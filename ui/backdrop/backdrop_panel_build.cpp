// The widgets of the floor plan's panel and their words.
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QShortcut>
#include <QSlider>
#include <QStackedWidget>

#include "floor/picture.h"
#include "ui/backdrop/backdrop_panel.h"
#include "ui/base/empty_page.h"
#include "ui/base/icon.h"
#include "ui/base/tidy.h"

namespace tessera::ui {
namespace {

constexpr int kKeysOfOnePlan = 10;  // the panel's numbers have a merge key each

QLabel* wrappingLabel(const char* name) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setWordWrap(true);
  return label;
}

}  // namespace

QWidget* BackdropPanel::makeEmptyPage() {
  emptyText_ = wrappingLabel("backdropEmpty");
  choose_ = new QPushButton{icon("plan"), {}};
  choose_->setObjectName("chooseBackdrop");
  connect(choose_, &QPushButton::clicked, this, &BackdropPanel::pictureWanted);
  return emptyPage(emptyText_, choose_);
}

QWidget* BackdropPanel::makePicturePage() {
  auto* page = new QWidget;
  name_ = wrappingLabel("backdropName");
  name_->setTextFormat(Qt::PlainText);
  QFont strong = font();
  strong.setBold(true);
  name_->setFont(strong);
  size_ = wrappingLabel("backdropSize");
  another_ = new QPushButton{icon("open"), {}};
  another_->setObjectName("anotherBackdrop");
  connect(another_, &QPushButton::clicked, this, &BackdropPanel::pictureWanted);
  remove_ = new QPushButton{icon("delete"), {}};
  remove_->setObjectName("removeBackdrop");
  connect(remove_, &QPushButton::clicked, this, [this] { tell(edits_.remove()); });
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(another_);
  buttons->addWidget(remove_);
  auto* layout = new QVBoxLayout{page};
  layout->addWidget(name_);
  layout->addWidget(size_);
  layout->addWidget(makeNumbers());
  layout->addWidget(makeScaling());
  layout->addLayout(buttons);
  layout->addStretch();
  auto* scroll = new QScrollArea;
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setWidget(page);
  return scroll;
}

QDoubleSpinBox* BackdropPanel::makeNumber(Number which, const char* name, double low, double high, double step,
                                          int decimals) {
  auto* box = new QDoubleSpinBox;
  box->setObjectName(name);
  box->setDecimals(decimals);
  box->setRange(low, high);
  box->setSingleStep(step);
  box->setKeyboardTracking(false);
  connect(box, &QDoubleSpinBox::valueChanged, this, [this, which](double value) { changed(which, value); });
  // What is typed next is a step of its own.
  connect(box, &QDoubleSpinBox::editingFinished, this, [this] { valueKey_ += kKeysOfOnePlan; });
  numbers_[which] = box;
  labels_[which] = new QLabel;
  labels_[which]->setBuddy(box);
  return box;
}

QWidget* BackdropPanel::makeNumbers() {
  auto* page = new QWidget;
  opacity_ = new QSlider{Qt::Horizontal};
  opacity_->setObjectName("backdropOpacity");
  opacity_->setRange(0, 100);
  opacity_->setPageStep(10);
  connect(opacity_, &QSlider::sliderPressed, this, [this] { valueKey_ += kKeysOfOnePlan; });
  connect(opacity_, &QSlider::valueChanged, this, [this](int percent) {
    if (!filling_) tell(edits_.setOpacity(percent / 100.0, valueKey_ + kNumbers));
  });
  opacityText_ = new QLabel;
  opacityText_->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("100 %")));
  opacityText_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  opacityLabel_ = new QLabel;
  opacityLabel_->setBuddy(opacity_);
  auto* opacity = new QHBoxLayout;
  opacity->addWidget(opacity_, 1);
  opacity->addWidget(opacityText_);
  const double far = kFarthest.value();
  auto* form = new QFormLayout{page};
  form->setContentsMargins(0, 0, 0, 0);
  form->addRow(opacityLabel_, opacity);
  auto* x = makeNumber(kX, "backdropX", -far, far, 0.1, 3);
  auto* y = makeNumber(kY, "backdropY", -far, far, 0.1, 3);
  auto* turn = makeNumber(kTurn, "backdropTurn", -360.0, 360.0, 1.0, 2);
  auto* pixel = makeNumber(kPixel, "backdropPixel", floor::kLeastBackdropPixel.value() * 1000.0,
                           floor::kMostBackdropPixel.value() * 1000.0, 0.1, 3);
  const std::array boxes{x, y, turn, pixel};
  for (std::size_t n = 0; n < boxes.size(); ++n) form->addRow(labels_[n], boxes[n]);
  return page;
}

QWidget* BackdropPanel::makeScaling() {
  auto* page = new QWidget;
  scale_ = new QPushButton{icon("measure"), {}};
  scale_->setObjectName("scaleBackdrop");
  connect(scale_, &QPushButton::clicked, this, &BackdropPanel::scalingWanted);
  scaling_ = new QWidget;
  scalingText_ = wrappingLabel("backdropScalingText");
  distance_ = new QDoubleSpinBox;
  distance_->setObjectName("backdropDistance");
  distance_->setDecimals(3);
  distance_->setRange(0.001, 2.0 * kFarthest.value());
  distanceLabel_ = new QLabel;
  distanceLabel_->setBuddy(distance_);
  connect(distance_->findChild<QLineEdit*>(), &QLineEdit::returnPressed, this, &BackdropPanel::applyDistance);
  apply_ = new QPushButton{icon("check"), {}};
  apply_->setObjectName("applyBackdropScale");
  connect(apply_, &QPushButton::clicked, this, &BackdropPanel::applyDistance);
  cancel_ = new QPushButton;
  cancel_->setObjectName("cancelBackdropScale");
  connect(cancel_, &QPushButton::clicked, this, &BackdropPanel::giveScalingUp);
  auto* escape = new QShortcut{QKeySequence{Qt::Key_Escape}, scaling_};
  escape->setContext(Qt::WidgetWithChildrenShortcut);
  connect(escape, &QShortcut::activated, this, &BackdropPanel::giveScalingUp);
  auto* row = new QHBoxLayout;
  row->addWidget(distanceLabel_);
  row->addWidget(distance_, 1);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(apply_);
  buttons->addWidget(cancel_);
  auto* inner = new QVBoxLayout{scaling_};
  inner->setContentsMargins(0, 0, 0, 0);
  inner->addWidget(scalingText_);
  inner->addLayout(row);
  inner->addLayout(buttons);
  auto* layout = new QVBoxLayout{page};
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(scale_);
  layout->addWidget(scaling_);
  return page;
}

void BackdropPanel::retranslate() {
  setWindowTitle(tr("Floor plan"));
  emptyText_->setText(
      tr("A picture of the building (PNG or JPEG) can lie beneath the floor, to lay tiles, zones and routes upon."));
  choose_->setText(tr("Choose a picture…"));
  another_->setText(tr("Another…"));
  another_->setToolTip(tr("Another picture in the place of this one"));
  remove_->setText(tr("Remove"));
  opacityLabel_->setText(tr("Opacity"));
  opacity_->setAccessibleName(tr("Opacity of the floor plan"));
  labels_[kX]->setText(tr("x"));
  labels_[kY]->setText(tr("y"));
  labels_[kTurn]->setText(tr("Turned"));
  labels_[kPixel]->setText(tr("One pixel"));
  const QString corner = tr("Place of the picture's lower left corner");
  numbers_[kX]->setToolTip(corner);
  numbers_[kY]->setToolTip(corner);
  numbers_[kTurn]->setToolTip(tr("About its lower left corner, counter-clockwise"));
  numbers_[kPixel]->setToolTip(tr("Length of a pixel's side on the floor"));
  for (const Number metres : {kX, kY}) numbers_[metres]->setSuffix(tr(" m", "after a number"));
  numbers_[kTurn]->setSuffix(QStringLiteral("°"));
  numbers_[kPixel]->setSuffix(tr(" mm", "after a number"));
  scale_->setText(tr("Scale by two points…"));
  scale_->setToolTip(tr("Click two points whose distance you know, then type it"));
  distanceLabel_->setText(tr("Distance"));
  distance_->setSuffix(tr(" m", "after a number"));
  apply_->setText(tr("Scale"));
  cancel_->setText(tr("Cancel"));
}

}  // namespace tessera::ui
