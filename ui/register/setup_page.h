// Before registering: which reader, which places in which order.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>

#include "ui/base/notice.h"
#include "ui/register/registrar.h"

namespace tessera::ui {

class SetupPage : public QWidget {
  Q_OBJECT
public:
  explicit SetupPage(Registrar& registrar, QWidget* parent = nullptr);

  /// Shows what was left of the open site, the tiles as they are now and the ports that are there.
  void refresh();
  /// This tile alone, as if it had been typed.
  void setTile(const QString& serial);
  /// As they were switched while scanning.
  void setSounds(bool on) { sounds_.setChecked(on); }

Q_SIGNALS:
  void startRequested(const tessera::scan::Course& course, const tessera::ui::ReaderChoice& reader);

protected:
  void changeEvent(QEvent* event) override;

private:
  void build();
  void retranslate();
  void fillPorts();
  void fillChoices();
  void showWays();
  void start(bool goOn);
  void clearTile();
  [[nodiscard]] ReaderChoice chosen() const;
  /// Nullopt: nothing is left of what was begun.
  [[nodiscard]] std::optional<scan::PlaceName> whereToGoOn() const;
  [[nodiscard]] QString serial() const { return tile_.text().trimmed(); }

  Registrar& registrar_;
  QLabel intro_;
  QLabel readerLabel_, portLabel_, baudLabel_, formLabel_, orderLabel_;
  QComboBox reader_, port_, baud_, form_, order_;
  QToolButton refreshPorts_;
  QCheckBox one_, again_, sounds_;
  QLineEdit tile_;
  QPushButton clearTile_, start_, goOn_;
  QLabel goOnText_;
  Notice notice_;
};

}  // namespace tessera::ui
