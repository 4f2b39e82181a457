#include "ui/calibrate/panel_parts.h"

#include "ui/base/icon.h"

namespace tessera::ui {

QLabel* sentenceLabel(QWidget* parent, const char* name) {
  auto* label = new QLabel{parent};
  label->setObjectName(QLatin1String{name});
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  return label;
}

QPushButton* orderButton(QWidget* parent, const char* name, const char* picture) {
  auto* button = new QPushButton{icon(QLatin1String{picture}), QString{}, parent};
  button->setObjectName(QLatin1String{name});
  return button;
}

QString nameOf(const SiteDocument& document, std::optional<VehicleId> vehicle) {
  const auto* setup = vehicle ? document.map()->vehicle(*vehicle) : nullptr;
  return setup == nullptr ? QString{} : QString::fromStdString(setup->name);
}

}  // namespace tessera::ui
