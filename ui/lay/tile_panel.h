// What is laid next, and the chosen tiles by number: for those who know serial numbers and centimetres.
#pragma once

#include <QWidget>

#include "ui/lay/lay_tool.h"

class QAction;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QMenu;
class QPushButton;
class QSpinBox;
class QStackedWidget;
class QToolBar;
class QToolButton;

namespace tessera::ui {

class TilePanel : public QWidget {
  Q_OBJECT
public:
  /// Both must outlive it.
  TilePanel(SiteDocument& document, LayTool& tool, QWidget* parent = nullptr);
  ~TilePanel() override;

Q_SIGNALS:
  /// The operator wants to make or change tile types.
  void typesRequested();
  /// The operator chose how to work: the tool is to be taken in hand.
  void toolRequested();

protected:
  void changeEvent(QEvent* event) override;

private:
  QWidget* makeEmptyPage();
  QWidget* makeMainPage();
  QWidget* makeNext();
  QWidget* makeDetails();
  void makeActions();
  void retranslate();
  void refresh();
  void refreshTypes();
  void refreshNext();
  void refreshChosen();
  void showOne(const std::string& serial);
  void showSeveral();
  void takeRule();
  void takePlace();
  void begin(LayTool::Mode mode);

  SiteDocument& document_;
  LayTool& tool_;
  QStackedWidget* pages_;
  QLabel* emptyText_ = nullptr;
  QPushButton* emptyButton_ = nullptr;
  QToolBar* bar_ = nullptr;
  QAction* layMode_ = nullptr;
  QAction* chooseMode_ = nullptr;
  QAction* turn_ = nullptr;
  QAction* duplicate_ = nullptr;
  QAction* delete_ = nullptr;
  QToolButton* alignButton_ = nullptr;
  QMenu* alignMenu_ = nullptr;
  QLabel* typeLabel_ = nullptr;
  QComboBox* type_ = nullptr;
  QPushButton* types_ = nullptr;
  QLabel* prefixLabel_ = nullptr;
  QLineEdit* prefix_ = nullptr;
  QLabel* digitsLabel_ = nullptr;
  QSpinBox* digits_ = nullptr;
  QLabel* numberLabel_ = nullptr;
  QSpinBox* number_ = nullptr;
  QLabel* nextLabel_ = nullptr;
  QLabel* next_ = nullptr;
  QLabel* summary_ = nullptr;
  QWidget* details_ = nullptr;
  QLabel* serialLabel_ = nullptr;
  QLineEdit* serial_ = nullptr;
  QLabel* ofTypeLabel_ = nullptr;
  QLabel* ofType_ = nullptr;
  QLabel* xLabel_ = nullptr;
  QDoubleSpinBox* x_ = nullptr;
  QLabel* yLabel_ = nullptr;
  QDoubleSpinBox* y_ = nullptr;
  QLabel* turnsLabel_ = nullptr;
  QComboBox* turns_ = nullptr;
  QLabel* tagsLabel_ = nullptr;
  QLabel* tags_ = nullptr;
  Point shownLow_;        ///< of the chosen tile, more exactly than its numbers
  bool filling_ = false;  ///< what changes in the widgets is not the operator's doing
  int placeKey_;          ///< merge key of turns of the place's numbers in a row
};

}  // namespace tessera::ui
