// What an empty panel says: a picture, a sentence, and where there is one, a button for the next step.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>

namespace tessera::ui {

class FleetHint : public QWidget {
  Q_OBJECT
public:
  explicit FleetHint(const QString& iconName, QWidget* parent = nullptr);

  /// Without a text for it there is no button.
  void setTexts(const QString& sentence, const QString& button = {});
  [[nodiscard]] QString sentence() const { return sentence_->text(); }
  [[nodiscard]] QPushButton* button() const { return button_; }

protected:
  void changeEvent(QEvent* event) override;

private:
  void drawPicture();

  QString iconName_;
  QLabel* picture_;
  QLabel* sentence_;
  QPushButton* button_;
};

}  // namespace tessera::ui
