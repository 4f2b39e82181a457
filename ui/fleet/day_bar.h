// Which day of the journal is shown: a date with a calendar, the days before and after it, and the way back to now.
#pragma once

#include <QDateEdit>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QWidget>

namespace tessera::ui {

class DayBar : public QWidget {
  Q_OBJECT
public:
  explicit DayBar(QWidget* parent = nullptr);

  [[nodiscard]] QDate day() const { return date_.date(); }
  /// Begins with yesterday, whose faults are looked for most often; later with the day that was shown last.
  void begin();

Q_SIGNALS:
  void dayChosen(const QDate& day);
  void left();

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslate();
  void showReach();

  QLabel label_;
  QToolButton before_;
  QDateEdit date_;
  QToolButton after_;
  QPushButton now_;
  bool begun_ = false;
};

}  // namespace tessera::ui
