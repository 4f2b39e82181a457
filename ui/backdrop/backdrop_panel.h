// The picture beneath the floor by numbers: opacity, place, direction, scale.
#pragma once

#include <QWidget>
#include <array>

#include "ui/backdrop/backdrop_tool.h"

class QDoubleSpinBox;
class QGroupBox;
class QLabel;
class QPushButton;
class QSlider;
class QStackedWidget;

namespace tessera::ui {

class BackdropPanel : public QWidget {
  Q_OBJECT
public:
  /// Both must outlive it.
  BackdropPanel(SiteDocument& document, BackdropTool& tool, QWidget* parent = nullptr);
  ~BackdropPanel() override;

Q_SIGNALS:
  /// The operator wants to choose a picture's file.
  void pictureWanted();
  /// The two points are to be clicked on the floor.
  void scalingWanted();
  /// The distance was typed, or scaling given up.
  void scalingEnded();
  /// One sentence: why something was not done.
  void refused(const QString& sentence);

protected:
  void changeEvent(QEvent* event) override;

private:
  enum Number { kX, kY, kTurn, kPixel, kNumbers };

  QWidget* makeEmptyPage();
  QWidget* makePicturePage();
  QWidget* makeNumbers();
  QWidget* makeScaling();
  QDoubleSpinBox* makeNumber(Number which, const char* name, double low, double high, double step, int decimals);
  void retranslate();
  void refresh();
  void refreshScaling();
  void changed(Number which, double value);
  void applyDistance();
  void giveScalingUp();
  template <class T>
  void tell(const Result<T>& result) {
    if (!result) refuse(result.error());
  }
  void refuse(const Error& why);

  SiteDocument& document_;
  BackdropTool& tool_;
  BackdropEdits edits_;
  std::shared_ptr<const BackdropPicture> picture_;
  QStackedWidget* pages_ = nullptr;
  QLabel* emptyText_ = nullptr;
  QPushButton* choose_ = nullptr;
  QLabel* name_ = nullptr;
  QLabel* size_ = nullptr;
  QLabel* opacityLabel_ = nullptr;
  QSlider* opacity_ = nullptr;
  QLabel* opacityText_ = nullptr;
  std::array<QLabel*, kNumbers> labels_{};
  std::array<QDoubleSpinBox*, kNumbers> numbers_{};
  QPushButton* scale_ = nullptr;
  QWidget* scaling_ = nullptr;
  QLabel* scalingText_ = nullptr;
  QLabel* distanceLabel_ = nullptr;
  QDoubleSpinBox* distance_ = nullptr;
  QPushButton* apply_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QPushButton* another_ = nullptr;
  QPushButton* remove_ = nullptr;
  bool filling_ = false;  ///< what changes in the widgets is not the operator's doing
  int valueKey_;          ///< merge key of turns of one number, or of the slider, in a row
};

}  // namespace tessera::ui
