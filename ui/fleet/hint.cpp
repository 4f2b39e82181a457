#include "ui/fleet/hint.h"

#include <QEvent>
#include <QVBoxLayout>

#include "ui/fleet/tone.h"

namespace tessera::ui {

FleetHint::FleetHint(const QString& iconName, QWidget* parent)
    : QWidget{parent},
      iconName_{iconName},
      picture_{new QLabel{this}},
      sentence_{new QLabel{this}},
      button_{new QPushButton{this}} {
  picture_->setAlignment(Qt::AlignCenter);
  sentence_->setAlignment(Qt::AlignCenter);
  sentence_->setWordWrap(true);
  sentence_->setTextFormat(Qt::PlainText);
  button_->hide();
  auto* layout = new QVBoxLayout{this};
  layout->addStretch();
  layout->addWidget(picture_);
  layout->addWidget(sentence_);
  layout->addWidget(button_, 0, Qt::AlignCenter);
  layout->addStretch();
  drawPicture();
}

void FleetHint::setTexts(const QString& sentence, const QString& button) {
  sentence_->setText(sentence);
  button_->setText(button);
  button_->setVisible(!button.isEmpty());
}

void FleetHint::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) drawPicture();
  QWidget::changeEvent(event);
}

void FleetHint::drawPicture() {
  const int side = fontMetrics().height() * 2;
  picture_->setPixmap(tintedIcon(iconName_, toneColour(Tone::Quiet, palette()), side, devicePixelRatioF())
                          .pixmap(QSize{side, side}, devicePixelRatioF()));
}

}  // namespace tessera::ui
