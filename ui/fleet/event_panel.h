// What happened, newest last: read while it comes, or a day of the journal; filtered, copied, saved.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QStackedLayout>
#include <QToolButton>
#include <QTreeView>

#include "ui/base/fleet_link.h"
#include "ui/base/notice.h"
#include "ui/base/selection.h"
#include "ui/base/site_document.h"
#include "ui/fleet/day_bar.h"
#include "ui/fleet/event_model.h"
#include "ui/fleet/hint.h"

namespace tessera::ui {

class EventPanel : public QWidget {
  Q_OBJECT
public:
  EventPanel(FleetLink& link, Selection& selection, SiteDocument& document, QWidget* parent = nullptr);
  ~EventPanel() override;

  /// Turns the supervisor's time into the time of day. Without it an event gets the time of its arrival.
  void setClock(std::function<QDateTime(Seconds)> clock) { model_.setClock(std::move(clock)); }
  /// Lines of earlier runs, oldest first.
  void prepend(const std::vector<JournalLine>& history);
  /// A page of the day that was asked for last, oldest first; pages come the newest first.
  void showDay(const std::vector<JournalLine>& lines, JournalPart part);
  /// Why that day cannot be read: a complete sentence.
  void showDayFailure(const QString& sentence);

public Q_SLOTS:
  void copy();
  void clear();
  void save();

Q_SIGNALS:
  /// Answers come by showDay(). A later question takes the place of an earlier one.
  void dayWanted(const tessera::ui::JournalDay& day);

protected:
  void changeEvent(QEvent* event) override;

private:
  void build();
  QToolButton* makeButton(const QString& name, const QString& iconName, void (EventPanel::*does)());
  void retranslate();
  void takeVehicles();
  void filter();
  void showAll();
  void goToEnd();
  void showWhatThereIs();
  void sizeColumns();
  void chooseDay(bool on);
  void askForDay();
  [[nodiscard]] bool showsDay() const { return shown_.sourceModel() == &past_; }
  [[nodiscard]] const EventModel& listed() const { return showsDay() ? past_ : model_; }

  FleetLink& link_;
  Selection& selection_;
  SiteDocument& document_;
  EventModel model_;
  EventModel past_;       ///< of one day of the journal
  bool reading_ = false;  ///< more of that day is on its way
  QString failure_;
  EventFilter shown_;
  QComboBox* severity_ = nullptr;
  QComboBox* vehicle_ = nullptr;
  QLineEdit* words_ = nullptr;
  QToolButton* toEnd_ = nullptr;
  QToolButton* copy_ = nullptr;
  QToolButton* clear_ = nullptr;
  QToolButton* save_ = nullptr;
  QToolButton* byDay_ = nullptr;
  DayBar* days_ = nullptr;
  Notice* tooMany_ = nullptr;
  QTreeView* view_ = nullptr;
  FleetHint* nothing_ = nullptr;
  QStackedLayout* pages_ = nullptr;
  bool atEnd_ = true;  ///< the newest line is kept in view
};

}  // namespace tessera::ui
