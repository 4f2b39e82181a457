#include "ui/find/find_box.h"

#include <QEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace tessera::ui {
namespace {

QString kindText(FoundPlace::Kind kind) {
  switch (kind) {
    case FoundPlace::Kind::Coordinates:
      return FindBox::tr("Coordinates");
    case FoundPlace::Kind::Tag:
      return FindBox::tr("Tag");
    case FoundPlace::Kind::Tile:
      return FindBox::tr("Tile");
    case FoundPlace::Kind::Zone:
      return FindBox::tr("Zone");
    case FoundPlace::Kind::Route:
      return FindBox::tr("Route");
    case FoundPlace::Kind::Vehicle:
      return FindBox::tr("Vehicle's start");
  }
  return {};
}

}  // namespace

FindBox::FindBox(const SiteDocument& document, QWidget* over) : QFrame{over}, document_{document} {
  setObjectName(QStringLiteral("findBox"));
  setProperty("helpTopic", QStringLiteral("floor"));
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  text_ = new QLineEdit;
  text_->setObjectName(QStringLiteral("findText"));
  text_->setClearButtonEnabled(true);
  text_->setMaxLength(200);
  list_ = new QListWidget;
  list_->setObjectName(QStringLiteral("findList"));
  list_->setFocusPolicy(Qt::NoFocus);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  none_ = new QLabel;
  none_->setObjectName(QStringLiteral("findNone"));
  auto* column = new QVBoxLayout{this};
  column->setContentsMargins(6, 6, 6, 6);
  column->addWidget(text_);
  column->addWidget(list_);
  column->addWidget(none_);
  connect(text_, &QLineEdit::textEdited, this, &FindBox::look);
  connect(list_, &QListWidget::itemClicked, this, [this] { go(list_->currentRow()); });
  text_->installEventFilter(this);
  over->installEventFilter(this);
  retranslate();
  hide();
}

void FindBox::retranslate() {
  text_->setPlaceholderText(tr("Tile, UID, zone, route, or x y in m"));
  text_->setAccessibleName(tr("Go to"));
  list_->setAccessibleName(tr("Places found"));
  none_->setText(tr("Nothing is called so."));
}

void FindBox::open() {
  show();
  raise();
  text_->setFocus(Qt::ShortcutFocusReason);
  text_->selectAll();
  look();
}

void FindBox::look() {
  found_ = findPlaces(*document_.map(), text_->text());
  list_->clear();
  for (const FoundPlace& place : found_)
    list_->addItem(tr("%1  %2", "kind and name").arg(kindText(place.kind), place.name));
  if (!found_.empty()) list_->setCurrentRow(0);
  list_->setVisible(!found_.empty());
  none_->setVisible(found_.empty() && !text_->text().trimmed().isEmpty());
  fitOver();
}

void FindBox::fitOver() {
  const int line = fontMetrics().height();
  const int rows = std::clamp(static_cast<int>(found_.size()), 1, 8);
  list_->setFixedHeight(rows * std::max(list_->sizeHintForRow(0), line) + 2 * list_->frameWidth());
  const int width = std::min(24 * line, parentWidget()->width() - 2 * line);
  setFixedWidth(std::max(width, 8 * line));
  layout()->activate();
  adjustSize();
  move((parentWidget()->width() - this->width()) / 2, line);
}

void FindBox::go(int row) {
  if (row < 0 || row >= static_cast<int>(found_.size())) return;
  const SiteBox box = found_[static_cast<std::size_t>(row)].box;
  hide();
  Q_EMIT chosen(box);
}

bool FindBox::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize && isVisible()) fitOver();
  if (watched != text_) return QFrame::eventFilter(watched, event);
  if (event->type() == QEvent::FocusOut && static_cast<QFocusEvent*>(event)->reason() != Qt::PopupFocusReason &&
      static_cast<QFocusEvent*>(event)->reason() != Qt::ActiveWindowFocusReason)
    hide();
  if (event->type() != QEvent::KeyPress) return QFrame::eventFilter(watched, event);
  switch (static_cast<QKeyEvent*>(event)->key()) {
    case Qt::Key_Escape:
      hide();
      Q_EMIT left();
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      go(list_->currentRow());
      return true;
    case Qt::Key_Down:
    case Qt::Key_Up: {
      const int step = static_cast<QKeyEvent*>(event)->key() == Qt::Key_Down ? 1 : -1;
      if (!found_.empty()) list_->setCurrentRow(std::clamp(list_->currentRow() + step, 0, list_->count() - 1));
      return true;
    }
    default:
      return QFrame::eventFilter(watched, event);
  }
}

void FindBox::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    retranslate();
    if (isVisible()) look();
  }
  QFrame::changeEvent(event);
}

}  // namespace tessera::ui
