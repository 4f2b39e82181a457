// A small drawing of an E32 module with its jumpers M0 and M1: taken off for configuration, in place for service.
#pragma once

#include <QWidget>

namespace tessera::ui {

class JumperPicture : public QWidget {
  Q_OBJECT
public:
  enum class Jumpers { Off, On };

  explicit JumperPicture(Jumpers jumpers, QWidget* parent = nullptr);
  [[nodiscard]] QSize sizeHint() const override;

protected:
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  void retranslate();

  Jumpers jumpers_;
  QString caption_;
};

}  // namespace tessera::ui
