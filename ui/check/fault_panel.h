// Everything that is wrong with the site, while it is being edited: where it is, and what would mend it.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "ui/canvas/floor_marks.h"
#include "ui/check/fault_model.h"
#include "ui/check/fault_watch.h"

class QAction;
class QDoubleSpinBox;
class QLabel;
class QListView;
class QMenu;
class QStackedWidget;
class QToolBar;
class QToolButton;

namespace tessera::ui {

class FaultPanel : public QWidget {
  Q_OBJECT
public:
  /// Both must outlive it.
  FaultPanel(SiteDocument& document, FaultWatch& watch, QWidget* parent = nullptr);

  /// "Faults (3)", for the dock.
  [[nodiscard]] QString title() const;
  /// "2 errors, 1 warning", for the status bar.
  [[nodiscard]] QString summary() const;
  [[nodiscard]] QString summaryIcon() const;
  /// Of the listed faults that have a place, and which one is chosen. `route`: of that route's faults alone.
  [[nodiscard]] std::vector<FloorMark> marks(std::optional<std::size_t>& chosen, const QString& route = {}) const;
  /// As it was chosen the last time; the check follows.
  void setClearance(Metres clearance);
  /// What can be done with the fault of that row; it deletes itself when it closes. Null: there is no such row.
  [[nodiscard]] QMenu* menuOf(int row, bool inList = false);

Q_SIGNALS:
  /// Title, summary or marks are others.
  void changed();
  /// The operator wants to see this place on the floor.
  void placeWanted(const tessera::ui::SiteBox& place);
  /// The operator wants to see the list, with the fault that is chosen in it now.
  void listWanted();
  /// The operator wants vehicles to keep that much room.
  void clearanceChosen(tessera::Metres clearance);
  /// One sentence: why something was not done.
  void refused(const QString& sentence);

protected:
  void changeEvent(QEvent* event) override;

private:
  QWidget* makeBar();
  QWidget* makeClearance();
  void retranslate();
  void refresh();
  void filter();
  void choose(int row);
  void goTo(int row);
  void mend(const sitecheck::Fault& fault);
  void refreshActions();
  [[nodiscard]] int currentRow() const;

  SiteDocument& document_;
  FaultWatch& watch_;
  FaultModel* model_;
  QStackedWidget* pages_;
  QListView* list_;
  QLabel* empty_;
  QLabel* state_ = nullptr;
  QLabel* clearanceLabel_ = nullptr;
  QDoubleSpinBox* clearance_ = nullptr;
  QAction* errors_ = nullptr;
  QAction* warnings_ = nullptr;
  QAction* show_ = nullptr;
  QAction* mend_ = nullptr;
  bool filling_ = false;
};

}  // namespace tessera::ui
