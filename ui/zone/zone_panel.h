// The site's zones as a list, the chosen one's kind, numbers and corners: for those who know the numbers.
#pragma once

#include <QWidget>
#include <optional>

#include "ui/base/selection.h"
#include "ui/zone/corner_model.h"

class QAction;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QStackedWidget;
class QToolBar;

namespace tessera::ui {

class NameList;
class PlaceTable;

class ZonePanel : public QWidget {
  Q_OBJECT
public:
  /// Both must outlive it.
  ZonePanel(SiteDocument& document, Selection& selection, QWidget* parent = nullptr);

  /// Shows which corner is the chosen one on the floor; nullopt: none.
  void setCorner(std::optional<std::size_t> corner);
  /// Lets the chosen zone's name be edited in the list.
  void startRenaming();

Q_SIGNALS:
  /// The operator wants to draw a new zone of this kind on the floor.
  void drawRequested(tessera::floor::ZoneKind kind);
  /// The operator chose a zone in the list, to look at it or change it.
  void zoneActivated();
  /// A corner was chosen in the table; nullopt: none.
  void cornerSelected(std::optional<std::size_t> corner);
  /// One sentence: why something was not done.
  void refused(const QString& sentence);

protected:
  void changeEvent(QEvent* event) override;

private:
  QWidget* makeEmptyPage();
  QWidget* makeListPage();
  QWidget* makeDetails();
  QWidget* makeForm();
  void makeActions();
  void retranslate();
  void nameActions();
  void refreshList();
  void refreshDetails();
  void insertCorner();
  void deleteCorner();
  void duplicate();
  template <class T>
  bool tell(const Result<T>& result) {
    if (!result) refuse(result.error());
    return result.has_value();
  }
  void refuse(const Error& why);
  [[nodiscard]] std::optional<std::size_t> currentCorner() const;
  [[nodiscard]] floor::ZoneKind kindOfNew() const;

  SiteDocument& document_;
  Selection& selection_;
  ZoneEdits edits_;
  CornerModel* corners_;
  QStackedWidget* pages_ = nullptr;
  QLabel* emptyText_ = nullptr;
  QPushButton* emptyButton_ = nullptr;
  QToolBar* zoneBar_ = nullptr;
  QToolBar* cornerBar_ = nullptr;
  NameList* list_ = nullptr;
  QWidget* details_ = nullptr;
  PlaceTable* table_ = nullptr;
  QLabel* kindLabel_ = nullptr;
  QComboBox* kind_ = nullptr;
  QLabel* speedLabel_ = nullptr;
  QDoubleSpinBox* speed_ = nullptr;
  QLabel* directionLabel_ = nullptr;
  QDoubleSpinBox* direction_ = nullptr;
  QLabel* areaLabel_ = nullptr;
  QLabel* area_ = nullptr;
  QAction* draw_ = nullptr;
  QAction* rename_ = nullptr;
  QAction* duplicate_ = nullptr;
  QAction* delete_ = nullptr;
  QAction* insertCorner_ = nullptr;
  QAction* deleteCorner_ = nullptr;
  bool filling_ = false;  ///< what changes in the widgets is not the operator's doing
  int valueKey_ = 0;      ///< merge key of turns of one number in a row
};

}  // namespace tessera::ui
