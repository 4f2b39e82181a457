// Edits a place in a table in centimetres: one decimal, the language's decimal point, nothing that a site file could
// not hold.
#pragma once

#include <QDoubleSpinBox>
#include <QStyledItemDelegate>

#include "ui/base/tidy.h"

namespace tessera::ui {

class CentimetreDelegate : public QStyledItemDelegate {
  Q_OBJECT
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& /*option*/,
                        const QModelIndex& /*index*/) const override {
    auto* box = new QDoubleSpinBox{parent};
    const double most = 100.0 * kFarthest.value();
    box->setObjectName("centimetreEditor");
    box->setFrame(false);
    box->setDecimals(1);
    box->setRange(-most, most);
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    box->setAlignment(Qt::AlignRight);
    return box;
  }
  void setEditorData(QWidget* editor, const QModelIndex& index) const override {
    if (auto* box = qobject_cast<QDoubleSpinBox*>(editor)) box->setValue(index.data(Qt::EditRole).toDouble());
  }
  void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override {
    auto* box = qobject_cast<QDoubleSpinBox*>(editor);
    if (box == nullptr) return;
    box->interpretText();
    model->setData(index, box->value(), Qt::EditRole);
  }
};

}  // namespace tessera::ui
