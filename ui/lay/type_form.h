// The numbers of one tile type, in centimetres.
#pragma once

#include <QWidget>
#include <vector>

#include "floor/site.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace tessera::ui {

class TypeForm : public QWidget {
  Q_OBJECT
public:
  explicit TypeForm(QWidget* parent = nullptr);

  [[nodiscard]] const floor::TileType& type() const { return type_; }
  /// Shows it; says nothing of it.
  void setType(const floor::TileType& type);
  /// A tag there, or none: whatever the pattern was, it is one of its own now.
  void togglePlace(int column, int row);
  void editName();

Q_SIGNALS:
  /// By the operator.
  void edited();

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslate();
  void showNumbers();
  void take();
  void fit();

  floor::TileType type_;
  QLineEdit* name_;
  QDoubleSpinBox* width_;
  QDoubleSpinBox* height_;
  QDoubleSpinBox* pitch_;
  QComboBox* pattern_;
  QCheckBox* gap_;
  QSpinBox* columns_;
  QSpinBox* rows_;
  QDoubleSpinBox* marginX_;
  QDoubleSpinBox* marginY_;
  QPushButton* fit_;
  QFormLayout* form_;
  bool filling_ = false;
};

}  // namespace tessera::ui
