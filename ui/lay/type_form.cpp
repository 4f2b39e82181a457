#include "ui/lay/type_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <cmath>
#include <optional>

#include "floor/tile_pattern.h"
#include "floor/type_change.h"

namespace tessera::ui {
namespace {

// As the numbers show it: 0.15 m and not 0.15000000000000002.
Metres fromCentimetres(double value) { return Metres{std::round(value * 1e3) / 1e5}; }

std::vector<bool> placesOf(const floor::TileType& type, int columns, int rows) {
  std::vector<bool> places;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column)
      places.push_back(column < type.columns && row < type.rows && floor::hasTag(type, column, row));
  }
  return places;
}

bool isFitted(const floor::TileType& type) {
  const floor::TileType fitted = floor::withPlacesFitted(type);
  return fitted.columns == type.columns && fitted.rows == type.rows &&
         length(fitted.margin + -1.0 * type.margin) < Metres{1e-5};
}

}  // namespace

TypeForm::TypeForm(QWidget* parent) : QWidget{parent}, form_{new QFormLayout{this}} {
  const auto makeLength = [this](const char* name, double low, double high) {
    auto* box = new QDoubleSpinBox;
    box->setObjectName(name);
    box->setDecimals(3);
    box->setRange(low, high);
    box->setSingleStep(1.0);
    box->setKeyboardTracking(false);
    connect(box, &QDoubleSpinBox::valueChanged, this, &TypeForm::take);
    return box;
  };
  const auto makeCount = [this](const char* name) {
    auto* box = new QSpinBox;
    box->setObjectName(name);
    box->setRange(1, 100);
    connect(box, &QSpinBox::valueChanged, this, &TypeForm::take);
    return box;
  };
  filling_ = true;
  name_ = new QLineEdit;
  name_->setObjectName("typeName");
  name_->setMaxLength(60);
  connect(name_, &QLineEdit::textEdited, this, &TypeForm::take);
  width_ = makeLength("typeWidth", 1.0, 10'000.0);
  height_ = makeLength("typeHeight", 1.0, 10'000.0);
  pitch_ = makeLength("typePitch", 0.1, 10'000.0);
  pattern_ = new QComboBox;
  pattern_->setObjectName("typePattern");
  for (int n = 0; n < 3; ++n) pattern_->addItem({});
  connect(pattern_, &QComboBox::currentIndexChanged, this, &TypeForm::take);
  gap_ = new QCheckBox;
  gap_->setObjectName("typeGap");
  connect(gap_, &QCheckBox::toggled, this, &TypeForm::take);
  columns_ = makeCount("typeColumns");
  rows_ = makeCount("typeRows");
  marginX_ = makeLength("typeMarginX", 0.0, 10'000.0);
  marginY_ = makeLength("typeMarginY", 0.0, 10'000.0);
  fit_ = new QPushButton;
  fit_->setObjectName("typeFit");
  connect(fit_, &QPushButton::clicked, this, &TypeForm::fit);
  filling_ = false;
  form_->setContentsMargins(0, 0, 0, 0);
  for (QWidget* field : std::initializer_list<QWidget*>{name_, width_, height_, pitch_, pattern_, gap_, columns_, rows_,
                                                        marginX_, marginY_, fit_})
    form_->addRow(QStringLiteral(" "), field);
  retranslate();
}

void TypeForm::setType(const floor::TileType& type) {
  type_ = type;
  showNumbers();
}

void TypeForm::showNumbers() {
  filling_ = true;
  const auto put = [](QDoubleSpinBox& box, Metres length) { box.setValue(length.value() * 100.0); };
  if (const QString name = QString::fromStdString(type_.name); name_->text().trimmed() != name) name_->setText(name);
  put(*width_, type_.width);
  put(*height_, type_.height);
  put(*pitch_, type_.pitch);
  put(*marginX_, type_.margin.x);
  put(*marginY_, type_.margin.y);
  pattern_->setCurrentIndex(static_cast<int>(type_.pattern));
  gap_->setEnabled(type_.pattern == floor::Pattern::OneInTwo);
  gap_->setChecked(type_.startsWithGap);
  columns_->setValue(type_.columns);
  rows_->setValue(type_.rows);
  filling_ = false;
}

void TypeForm::take() {
  if (filling_) return;
  const bool fitted = isFitted(type_);
  floor::TileType to = type_;
  bool size = false;
  // A length that was not touched keeps what its three decimals do not show.
  const auto read = [&size](const QDoubleSpinBox& box, Metres& length) {
    if (std::abs(box.value() - length.value() * 100.0) <= 0.00051) return;
    length = fromCentimetres(box.value());
    size = true;
  };
  read(*width_, to.width);
  read(*height_, to.height);
  read(*pitch_, to.pitch);
  const bool refit = size && fitted;
  read(*marginX_, to.margin.x);
  read(*marginY_, to.margin.y);
  to.name = name_->text().trimmed().toStdString();
  to.pattern = static_cast<floor::Pattern>(pattern_->currentIndex());
  to.columns = columns_->value();
  to.rows = rows_->value();
  to.startsWithGap = to.pattern == floor::Pattern::OneInTwo && gap_->isChecked();
  to.custom = to.pattern == floor::Pattern::Custom ? placesOf(type_, to.columns, to.rows) : std::vector<bool>{};
  type_ = refit ? floor::withPlacesFitted(to) : to;
  showNumbers();
  Q_EMIT edited();
}

void TypeForm::fit() {
  type_ = floor::withPlacesFitted(type_);
  showNumbers();
  Q_EMIT edited();
}

void TypeForm::togglePlace(int column, int row) {
  if (type_.pattern != floor::Pattern::Custom) {
    type_.custom = placesOf(type_, type_.columns, type_.rows);
    type_.pattern = floor::Pattern::Custom;
    type_.startsWithGap = false;
  }
  const auto place =
      static_cast<std::size_t>(row) * static_cast<std::size_t>(type_.columns) + static_cast<std::size_t>(column);
  if (place >= type_.custom.size()) return;
  type_.custom[place] = !type_.custom[place];
  showNumbers();
  Q_EMIT edited();
}

void TypeForm::editName() {
  name_->setFocus();
  name_->selectAll();
}

void TypeForm::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void TypeForm::retranslate() {
  const auto label = [this](QWidget* field, const QString& text) {
    if (auto* at = qobject_cast<QLabel*>(form_->labelForField(field))) at->setText(text);
  };
  label(name_, tr("Name"));
  label(width_, tr("Width"));
  label(height_, tr("Height"));
  label(pitch_, tr("Pitch"));
  label(pattern_, tr("Pattern"));
  label(columns_, tr("Places in a row"));
  label(rows_, tr("Rows"));
  label(marginX_, tr("First place from the left edge"));
  label(marginY_, tr("First place from the lower edge"));
  for (QDoubleSpinBox* box : {width_, height_, pitch_, marginX_, marginY_}) box->setSuffix(tr(" cm"));
  pitch_->setToolTip(tr("From one place to the next, along rows and columns"));
  pattern_->setItemText(0, tr("A tag at every place"));
  pattern_->setItemText(1, tr("A tag at every second place"));
  pattern_->setItemText(2, tr("As clicked in the drawing"));
  gap_->setText(tr("Starts with a gap"));
  gap_->setToolTip(tr("The first place at the lower left is without a tag"));
  fit_->setText(tr("Fit the places to the tile"));
  fit_->setToolTip(tr("As many places as the pitch lets on the tile, in its middle"));
}

}  // namespace tessera::ui
