// The site's routes as a list, the chosen one's vertices as a table: for those who know the numbers.
#pragma once

#include <QWidget>
#include <optional>

#include "ui/base/selection.h"
#include "ui/route/vertex_model.h"

class QAction;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QStackedWidget;
class QToolBar;

namespace tessera::ui {

class NameList;
class PlaceTable;

class RoutePanel : public QWidget {
  Q_OBJECT
public:
  /// Both must outlive it.
  RoutePanel(SiteDocument& document, Selection& selection, QWidget* parent = nullptr);

  /// Shows which vertex is the chosen one on the floor; nullopt: none.
  void setVertex(std::optional<std::size_t> vertex);
  /// Lets the chosen route's name be edited in the list.
  void startRenaming();

Q_SIGNALS:
  /// The operator wants to draw a new route on the floor.
  void drawRequested();
  /// A vertex was chosen in the table; nullopt: none.
  void vertexSelected(std::optional<std::size_t> vertex);
  /// One sentence: why something was not done.
  void refused(const QString& sentence);

protected:
  void changeEvent(QEvent* event) override;

private:
  QWidget* makeEmptyPage();
  QWidget* makeListPage();
  QWidget* makeDetails();
  void makeActions();
  void retranslate();
  void refreshList();
  void refreshDetails();
  void insertVertex();
  void deleteVertex();
  void duplicate();
  void join();
  void split();
  void refreshActions();
  void refreshTime();
  void tell(const Result<void>& result);
  [[nodiscard]] std::optional<std::size_t> currentVertex() const;

  SiteDocument& document_;
  Selection& selection_;
  RouteEdits edits_;
  VertexModel* vertices_;
  QStackedWidget* pages_ = nullptr;
  QLabel* emptyText_ = nullptr;
  QPushButton* emptyButton_ = nullptr;
  QToolBar* routeBar_ = nullptr;
  QToolBar* vertexBar_ = nullptr;
  NameList* list_ = nullptr;
  QWidget* details_ = nullptr;
  PlaceTable* table_ = nullptr;
  QLabel* spacingLabel_ = nullptr;
  QDoubleSpinBox* spacing_ = nullptr;
  QLabel* speedLabel_ = nullptr;
  QDoubleSpinBox* speed_ = nullptr;
  QLabel* lengthLabel_ = nullptr;
  QLabel* length_ = nullptr;
  QAction* draw_ = nullptr;
  QAction* rename_ = nullptr;
  QAction* duplicate_ = nullptr;
  QAction* reverse_ = nullptr;
  QAction* join_ = nullptr;
  QAction* split_ = nullptr;
  QAction* delete_ = nullptr;
  QAction* insertVertex_ = nullptr;
  QAction* deleteVertex_ = nullptr;
  bool filling_ = false;  ///< what changes in the widgets is not the operator's doing
  int spacingKey_ = 0;    ///< merge key of turns of the spacing in a row
};

}  // namespace tessera::ui
