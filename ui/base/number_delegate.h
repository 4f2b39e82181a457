// Edits a number in a table: so many decimals, the language's decimal point, nothing beyond what is allowed there.
#pragma once

#include <QDoubleSpinBox>
#include <QStyledItemDelegate>

namespace tessera::ui {

class NumberDelegate : public QStyledItemDelegate {
  Q_OBJECT
public:
  struct Form {
    const char* name;  ///< of the editor, for tests
    int decimals;
    double low;
    double high;
    double step;
    bool mayBeEmpty = false;  ///< the lowest number is shown as nothing, and nothing is that number
  };
  NumberDelegate(const Form& form, QObject* parent) : QStyledItemDelegate{parent}, form_{form} {}

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  void setEditorData(QWidget* editor, const QModelIndex& index) const override;
  /// Gives the model an invalid value for nothing.
  void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;

private:
  Form form_;
};

}  // namespace tessera::ui
