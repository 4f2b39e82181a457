// A new site: its name, and a first floor of equal tiles or an empty one.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>

#include "floor/new_floor.h"

namespace tessera::ui {

class NewSiteDialog : public QDialog {
  Q_OBJECT
public:
  explicit NewSiteDialog(QWidget* parent = nullptr);
  /// The name is never empty.
  [[nodiscard]] floor::NewFloor wish() const;

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslate();
  void showSize();

  QLabel nameLabel_;
  QLineEdit name_;
  QLabel typeLabel_;
  QComboBox type_;
  QLabel columnsLabel_;
  QSpinBox columns_;
  QLabel rowsLabel_;
  QSpinBox rows_;
  QLabel sizeLabel_;
  QLabel size_;
  QCheckBox empty_;
  QCheckBox practice_;
  QLabel practiceHint_;
  QDialogButtonBox buttons_;
};

}  // namespace tessera::ui
