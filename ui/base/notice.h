// One sentence in a tinted box: what is wrong or worth knowing, and what to do. Empty, it takes no room.
#pragma once

#include <QLabel>

namespace tessera::ui {

class Notice : public QLabel {
  Q_OBJECT
public:
  enum class Tone { Info, Good, Warning, Error };

  explicit Notice(QWidget* parent = nullptr);
  void show(Tone tone, const QString& sentence);
  void clear();
  [[nodiscard]] Tone tone() const { return tone_; }

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  [[nodiscard]] QColor tint() const;

  Tone tone_ = Tone::Info;
};

}  // namespace tessera::ui
