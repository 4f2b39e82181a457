#include "ui/base/number_delegate.h"

namespace tessera::ui {
namespace {

class MaybeNumberBox : public QDoubleSpinBox {
public:
  using QDoubleSpinBox::QDoubleSpinBox;

protected:
  QValidator::State validate(QString& input, int& at) const override {
    return input.trimmed().isEmpty() ? QValidator::Acceptable : QDoubleSpinBox::validate(input, at);
  }
  [[nodiscard]] double valueFromText(const QString& text) const override {
    return text.trimmed().isEmpty() ? minimum() : QDoubleSpinBox::valueFromText(text);
  }
  [[nodiscard]] QString textFromValue(double value) const override {
    return value <= minimum() ? QString{} : QDoubleSpinBox::textFromValue(value);
  }
};

}  // namespace

QWidget* NumberDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem& /*option*/,
                                      const QModelIndex& /*index*/) const {
  auto* box = form_.mayBeEmpty ? new MaybeNumberBox{parent} : new QDoubleSpinBox{parent};
  box->setObjectName(QLatin1String{form_.name});
  box->setFrame(false);
  box->setDecimals(form_.decimals);
  box->setRange(form_.low, form_.high);
  box->setSingleStep(form_.step);
  box->setButtonSymbols(QAbstractSpinBox::NoButtons);
  box->setAlignment(Qt::AlignRight);
  return box;
}

void NumberDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
  auto* box = qobject_cast<QDoubleSpinBox*>(editor);
  if (box == nullptr) return;
  const QVariant value = index.data(Qt::EditRole);
  box->setValue(value.isValid() ? value.toDouble() : box->minimum());
}

void NumberDelegate::setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const {
  auto* box = qobject_cast<QDoubleSpinBox*>(editor);
  if (box == nullptr) return;
  box->interpretText();
  const bool nothing = form_.mayBeEmpty && box->value() <= box->minimum();
  model->setData(index, nothing ? QVariant{} : QVariant{box->value()}, Qt::EditRole);
}

}  // namespace tessera::ui
