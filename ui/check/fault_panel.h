// Everything that is wrong with the site, while it is being edited: where it is, and what would mend it.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "ui/canvas/floor_marks.h"
#include "ui/check/fault_model.h"
#include "ui/check/fault_watch.h"

class QAction;
class QLabel;
class QListView;
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
  /// Of the listed faults that have a place, and which one is chosen.
  [[nodiscard]] std::vector<FloorMark> marks(std::optional<std::size_t>& chosen) const;

Q_SIGNALS:
  /// Title, summary or marks are others.
  void changed();
  /// The operator wants to see this place on the floor.
  void placeWanted(const tessera::ui::SiteBox& place);
  /// One sentence: why something was not done.
  void refused(const QString& sentence);

protected:
  void changeEvent(QEvent* event) override;

private:
  QWidget* makeBar();
  void retranslate();
  void refresh();
  void filter();
  void choose(int row);
  void goTo(int row);
  void mend();
  void refreshActions();
  [[nodiscard]] int currentRow() const;

  SiteDocument& document_;
  FaultWatch& watch_;
  FaultModel* model_;
  QStackedWidget* pages_;
  QListView* list_;
  QLabel* empty_;
  QLabel* state_ = nullptr;
  QAction* errors_ = nullptr;
  QAction* warnings_ = nullptr;
  QAction* show_ = nullptr;
  QAction* mend_ = nullptr;
  bool filling_ = false;
};

}  // namespace tessera::ui
