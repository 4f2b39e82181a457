#include "ui/lay/tile_panel.h"

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QSpinBox>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <set>

#include "floor/laid_tile.h"

namespace tessera::ui {
namespace {

constexpr int kFirstPlaceKey = 3'000'000;

std::size_t registeredOn(const floor::Tile& tile) {
  return static_cast<std::size_t>(
      std::count_if(tile.uids.begin(), tile.uids.end(), [](const floor::TagUid& uid) { return !uid.empty(); }));
}

}  // namespace

TilePanel::TilePanel(SiteDocument& document, LayTool& tool, QWidget* parent)
    : QWidget{parent}, document_{document}, tool_{tool}, pages_{new QStackedWidget}, placeKey_{kFirstPlaceKey} {
  setObjectName("tilePanel");
  makeActions();
  pages_->addWidget(makeEmptyPage());
  pages_->addWidget(makeMainPage());
  auto* layout = new QVBoxLayout{this};
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(pages_);
  connect(&document_, &SiteDocument::changed, this, &TilePanel::refresh);
  connect(&tool_, &LayTool::settingsChanged, this, &TilePanel::refreshNext);
  connect(&tool_, &LayTool::chosenChanged, this, [this] {
    ++placeKey_;
    refreshChosen();
  });
  retranslate();
  refresh();
}

// A field that has the focus finishes its editing while the window goes, when this is a panel no more.
TilePanel::~TilePanel() { serial_->disconnect(this); }

void TilePanel::begin(LayTool::Mode mode) {
  tool_.setMode(mode);
  refreshNext();  // the button that was pressed again stays pressed
  Q_EMIT toolRequested();
}

void TilePanel::refresh() {
  pages_->setCurrentIndex(document_.site().tileTypes.empty() ? 0 : 1);
  refreshTypes();
  refreshChosen();
}

void TilePanel::refreshTypes() {
  filling_ = true;
  QStringList names;
  for (const floor::TileType& type : document_.site().tileTypes) names << QString::fromStdString(type.name);
  QStringList shown;
  for (int n = 0; n < type_->count(); ++n) shown << type_->itemText(n);
  if (names != shown) {
    type_->clear();
    type_->addItems(names);
  }
  filling_ = false;
  refreshNext();
}

void TilePanel::refreshNext() {
  filling_ = true;
  layMode_->setChecked(tool_.mode() == LayTool::Mode::Lay);
  chooseMode_->setChecked(tool_.mode() == LayTool::Mode::Choose);
  type_->setCurrentIndex(type_->findText(QString::fromStdString(tool_.brush())));
  type_->setToolTip(type_->currentText());
  const floor::SerialRule& rule = tool_.rule();
  if (const QString prefix = QString::fromStdString(rule.prefix); prefix_->text() != prefix) prefix_->setText(prefix);
  digits_->setValue(rule.digits);
  number_->setValue(static_cast<int>(rule.next));
  filling_ = false;
  const QString serial = QString::fromStdString(floor::freeSerials(document_.site(), rule, 1).front());
  next_->setText(tool_.brushTurns() == 0 ? serial : tr("%1, turned by %2°").arg(serial).arg(90 * tool_.brushTurns()));
}

void TilePanel::refreshChosen() {
  const TileSet& chosen = tool_.chosen();
  for (QAction* action : {duplicate_, delete_}) action->setEnabled(!chosen.empty());
  alignButton_->setEnabled(!chosen.empty());
  details_->setVisible(chosen.size() == 1);
  if (chosen.size() == 1) {
    showOne(*chosen.begin());
  } else {
    showSeveral();
  }
}

void TilePanel::showSeveral() {
  const TileSet& chosen = tool_.chosen();
  if (chosen.empty()) {
    const std::size_t laid = document_.site().placements.size();
    summary_->setText(laid == 0 ? tr("No tile is laid yet: drag over the floor.")
                                : tr("%n tile(s) laid, none of them chosen.", nullptr, static_cast<int>(laid)));
    return;
  }
  std::set<std::string> types;
  std::size_t registered = 0;
  for (const floor::Tile& tile : document_.site().tiles) {
    if (!chosen.contains(tile.serial)) continue;
    types.insert(tile.type);
    registered += registeredOn(tile);
  }
  QString text = tr("%n tile(s) chosen.", nullptr, static_cast<int>(chosen.size()));
  text += QLatin1Char(' ') + (types.size() == 1 ? tr("Type: %1.").arg(QString::fromStdString(*types.begin()))
                                                : tr("%n type(s).", nullptr, static_cast<int>(types.size())));
  text += QLatin1Char(' ') + tr("%n tag(s) registered.", nullptr, static_cast<int>(registered));
  summary_->setText(text);
}

void TilePanel::showOne(const std::string& serial) {
  const floor::Site& site = document_.site();
  const auto tile =
      std::find_if(site.tiles.begin(), site.tiles.end(), [&](const floor::Tile& t) { return t.serial == serial; });
  const auto placement = std::find_if(site.placements.begin(), site.placements.end(),
                                      [&](const floor::Placement& p) { return p.serial == serial; });
  if (tile == site.tiles.end() || placement == site.placements.end()) return;
  const auto type = std::find_if(site.tileTypes.begin(), site.tileTypes.end(),
                                 [&](const floor::TileType& t) { return t.name == tile->type; });
  if (type == site.tileTypes.end()) return;
  filling_ = true;
  summary_->setText(tr("The chosen tile:"));
  if (const QString text = QString::fromStdString(serial); serial_->text() != text) serial_->setText(text);
  ofType_->setText(QString::fromStdString(tile->type));
  shownLow_ = floor::boxOf(*placement, *type).low;
  x_->setValue(shownLow_.x.value() * 100.0);
  y_->setValue(shownLow_.y.value() * 100.0);
  turns_->setCurrentIndex(placement->quarterTurns);
  tags_->setText(tr("%1 of %2 registered").arg(registeredOn(*tile)).arg(floor::tagOffsets(*type).size()));
  filling_ = false;
}

void TilePanel::takeRule() {
  if (filling_) return;
  tool_.setRule({prefix_->text().toStdString(), digits_->value(), number_->value()});
}

void TilePanel::takePlace() {
  if (filling_) return;
  // Only a number that was changed: the others may be finer than what is shown.
  Point low = shownLow_;
  const auto take = [](const QDoubleSpinBox& box, Metres& to) {
    if (std::abs(box.value() - to.value() * 100.0) > 0.0051) to = Metres{box.value() / 100.0};
  };
  take(*x_, low.x);
  take(*y_, low.y);
  tool_.place(low, turns_->currentIndex(), placeKey_);
  refreshChosen();  // a place that was refused gives way to the old one
}

void TilePanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange) {
    retranslate();
    refreshNext();
    refreshChosen();
  }
  QWidget::changeEvent(event);
}

}  // namespace tessera::ui
