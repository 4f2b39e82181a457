// The properties of a site: its name, where north lies, the radio its vehicles share, and tags that belong to no tile.
// They are taken over together, as one step.
#pragma once

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QTabWidget>

#include "ui/base/notice.h"
#include "ui/base/site_document.h"
#include "ui/site/loose_tag_page.h"

namespace tessera::ui {

class SiteDialog : public QDialog {
  Q_OBJECT
public:
  explicit SiteDialog(SiteDocument& document, QWidget* parent = nullptr);

  /// Takes everything over; stays open with a sentence where the site would contradict itself.
  void accept() override;

protected:
  void changeEvent(QEvent* event) override;

private:
  void layOut();
  void fill();
  [[nodiscard]] floor::Site wanted() const;
  void retranslate();
  void showFrequency();

  SiteDocument& document_;
  QTabWidget tabs_;
  QLabel nameLabel_;
  QLineEdit name_;
  QLabel northLabel_;
  QDoubleSpinBox north_;
  QLabel northHint_;
  QLabel channelLabel_;
  QSpinBox channel_;
  QLabel airLabel_;
  QComboBox air_;
  QLabel baudLabel_;
  QComboBox baud_;
  QLabel radioHint_;
  LooseTagPage loose_;
  Notice refusal_;
  QDialogButtonBox buttons_;
};

}  // namespace tessera::ui
