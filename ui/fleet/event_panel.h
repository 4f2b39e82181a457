// What happened, newest last: read while it comes, filtered, copied.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QStackedLayout>
#include <QToolButton>
#include <QTreeView>

#include "ui/base/fleet_link.h"
#include "ui/base/selection.h"
#include "ui/base/site_document.h"
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

public Q_SLOTS:
  void copy();
  void clear();

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

  FleetLink& link_;
  Selection& selection_;
  SiteDocument& document_;
  EventModel model_;
  EventFilter shown_;
  QComboBox* severity_ = nullptr;
  QComboBox* vehicle_ = nullptr;
  QLineEdit* words_ = nullptr;
  QToolButton* toEnd_ = nullptr;
  QToolButton* copy_ = nullptr;
  QToolButton* clear_ = nullptr;
  QTreeView* view_ = nullptr;
  FleetHint* nothing_ = nullptr;
  QStackedLayout* pages_ = nullptr;
  bool atEnd_ = true;  ///< the newest line is kept in view
};

}  // namespace tessera::ui
