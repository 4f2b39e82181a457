#include "ui/base/empty_page.h"

#include <QVBoxLayout>

namespace tessera::ui {

QWidget* emptyPage(QLabel* what, QPushButton* next) {
  auto* page = new QWidget;
  what->setWordWrap(true);
  what->setAlignment(Qt::AlignCenter);
  auto* layout = new QVBoxLayout{page};
  layout->addStretch();
  layout->addWidget(what);
  layout->addSpacing(page->fontMetrics().height() / 2);
  layout->addWidget(next, 0, Qt::AlignCenter);
  layout->addStretch();
  return page;
}

}  // namespace tessera::ui
