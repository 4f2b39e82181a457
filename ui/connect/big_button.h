// A large button of the start page: icon, a title, and one line that says what will happen.
#pragma once

#include <QLabel>
#include <QPushButton>

namespace tessera::ui {

class BigButton : public QPushButton {
  Q_OBJECT
public:
  explicit BigButton(const QString& iconName, QWidget* parent = nullptr);

  /// The title may hold a mnemonic: "&New site".
  void setTexts(const QString& title, const QString& description);
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  [[nodiscard]] QFont titleFont() const;
  [[nodiscard]] int iconSide() const;
  [[nodiscard]] int gap() const;

  QIcon icon_;
  QString title_;
  QString description_;
};

}  // namespace tessera::ui
