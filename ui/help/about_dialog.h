// What the program is, in which version, of what it is made, and under which licence it may be used.
#pragma once

#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QTableWidget>

namespace tessera::ui {

class AboutDialog : public QDialog {
  Q_OBJECT
public:
  /// sqliteVersion: of the database that runs; empty: not told.
  explicit AboutDialog(QWidget* parent = nullptr, const QString& sqliteVersion = {});

  /// What the copy button puts on the clipboard: English, for reports.
  [[nodiscard]] QString report() const;

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslate();
  void fill();

  QString sqliteVersion_;
  QLabel name_;
  QLabel version_;
  QLabel sentence_;
  QTabWidget tabs_;
  QTableWidget parts_;
  QPlainTextEdit licence_;
  QDialogButtonBox buttons_;
  QPushButton copy_;
};

}  // namespace tessera::ui
