// The places of a vehicle's readers, one line each, with lines added and removed.
#pragma once

#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QWidget>
#include <vector>

#include "base/pose.h"

namespace tessera::ui {

class ReaderTable : public QWidget {
  Q_OBJECT
public:
  explicit ReaderTable(QWidget* parent = nullptr);
  void setReaders(const std::vector<Offset>& readers);
  [[nodiscard]] std::vector<Offset> readers() const;

Q_SIGNALS:
  void edited();

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslate();
  void fill();
  void add();
  void removeCurrent();
  void takeCells();

  std::vector<Offset> readers_;
  bool filling_ = false;
  QTableWidget table_;
  QPushButton add_;
  QPushButton remove_;
};

}  // namespace tessera::ui
