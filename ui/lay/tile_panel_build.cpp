// The widgets of the tile panel, their actions and their texts.
#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QSpinBox>
#include <QStackedWidget>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/base/empty_page.h"
#include "ui/base/icon.h"
#include "ui/lay/tile_panel.h"

namespace tessera::ui {

void TilePanel::makeActions() {
  const auto make = [this](const char* name, const char* picture, auto what) {
    auto* action = new QAction{icon(picture), {}, this};
    action->setObjectName(name);
    connect(action, &QAction::triggered, this, what);
    return action;
  };
  layMode_ = make("layTilesMode", "tile", [this] { begin(LayTool::Mode::Lay); });
  chooseMode_ = make("chooseTilesMode", "select", [this] { begin(LayTool::Mode::Choose); });
  turn_ = make("turnTiles", "turn-left", [this] { tool_.turn(); });
  duplicate_ = make("duplicateTiles", "duplicate", [this] { tool_.duplicate(); });
  delete_ = make("deleteTiles", "delete", [this] { tool_.removeChosen(); });
  auto* modes = new QActionGroup{this};
  for (QAction* action : {layMode_, chooseMode_}) {
    action->setCheckable(true);
    modes->addAction(action);
  }
  alignMenu_ = new QMenu{this};
  for (const auto line : {LayEdits::Line::Left, LayEdits::Line::Right, LayEdits::Line::Top, LayEdits::Line::Bottom,
                          LayEdits::Line::Lattice})
    alignMenu_->addAction(QString{}, this, [this, line] { tool_.align(line); });
}

QWidget* TilePanel::makeEmptyPage() {
  emptyText_ = new QLabel;
  emptyButton_ = new QPushButton{icon("tile"), {}};
  emptyButton_->setObjectName("makeFirstType");
  connect(emptyButton_, &QPushButton::clicked, this, &TilePanel::typesRequested);
  return emptyPage(emptyText_, emptyButton_);
}

QWidget* TilePanel::makeMainPage() {
  auto* page = new QWidget;
  bar_ = new QToolBar;
  const int side = fontMetrics().height() + 2;
  bar_->setIconSize({side, side});
  bar_->addActions({layMode_, chooseMode_});
  bar_->addSeparator();
  bar_->addActions({turn_, duplicate_, delete_});
  alignButton_ = new QToolButton;
  alignButton_->setObjectName("alignTiles");
  alignButton_->setIcon(icon("grid"));
  alignButton_->setMenu(alignMenu_);
  alignButton_->setPopupMode(QToolButton::InstantPopup);
  bar_->addWidget(alignButton_);
  summary_ = new QLabel;
  summary_->setObjectName("chosenTiles");
  summary_->setWordWrap(true);
  details_ = makeDetails();
  auto* body = new QWidget;
  auto* column = new QVBoxLayout{body};
  column->addWidget(makeNext());
  column->addSpacing(fontMetrics().height() / 2);
  column->addWidget(summary_);
  column->addWidget(details_);
  column->addStretch();
  // It scrolls where it has no room: it must not make the window larger.
  auto* scroll = new QScrollArea;
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(body);
  auto* layout = new QVBoxLayout{page};
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(bar_);
  layout->addWidget(scroll, 1);
  return page;
}

QWidget* TilePanel::makeNext() {
  auto* page = new QWidget;
  type_ = new QComboBox;
  type_->setObjectName("layType");
  type_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  type_->setMinimumContentsLength(8);
  connect(type_, &QComboBox::currentTextChanged, this, [this](const QString& name) {
    if (!filling_) tool_.setBrush(name.toStdString());
  });
  types_ = new QPushButton;
  types_->setObjectName("openTileTypes");
  connect(types_, &QPushButton::clicked, this, &TilePanel::typesRequested);
  prefix_ = new QLineEdit;
  prefix_->setObjectName("serialPrefix");
  prefix_->setMaxLength(100);
  connect(prefix_, &QLineEdit::textEdited, this, &TilePanel::takeRule);
  const auto makeSpin = [this](const char* name, int low, int high) {
    auto* box = new QSpinBox;
    box->setObjectName(name);
    box->setRange(low, high);
    connect(box, &QSpinBox::valueChanged, this, &TilePanel::takeRule);
    return box;
  };
  filling_ = true;
  digits_ = makeSpin("serialDigits", 1, floor::SerialRule::kMostDigits);
  number_ = makeSpin("serialNumber", 0, 999'999'999);
  filling_ = false;
  next_ = new QLabel;
  next_->setObjectName("nextSerial");
  next_->setWordWrap(true);
  const auto labelFor = [](QWidget* field) {
    auto* label = new QLabel;
    label->setBuddy(field);
    return label;
  };
  typeLabel_ = labelFor(type_);
  prefixLabel_ = labelFor(prefix_);
  digitsLabel_ = labelFor(digits_);
  numberLabel_ = labelFor(number_);
  nextLabel_ = new QLabel;
  auto* form = new QFormLayout{page};
  form->setContentsMargins(0, 0, 0, 0);
  // Names of types are long: the whole width is theirs.
  form->addRow(typeLabel_);
  form->addRow(type_);
  form->addRow(types_);
  form->addRow(prefixLabel_, prefix_);
  form->addRow(digitsLabel_, digits_);
  form->addRow(numberLabel_, number_);
  form->addRow(nextLabel_, next_);
  return page;
}

QWidget* TilePanel::makeDetails() {
  auto* page = new QWidget;
  page->setObjectName("tileDetails");
  serial_ = new QLineEdit;
  serial_->setObjectName("tileSerial");
  connect(serial_, &QLineEdit::editingFinished, this, [this] {
    if (filling_) return;
    tool_.rename(serial_->text());
    refreshChosen();  // a name that was refused gives way to the old one
  });
  ofType_ = new QLabel;
  ofType_->setObjectName("tileOfType");
  ofType_->setWordWrap(true);
  const auto makeBox = [this](const char* name) {
    auto* box = new QDoubleSpinBox;
    box->setObjectName(name);
    box->setDecimals(2);
    box->setRange(-1e7, 1e7);
    box->setSingleStep(1.0);
    box->setKeyboardTracking(false);
    connect(box, &QDoubleSpinBox::valueChanged, this, &TilePanel::takePlace);
    return box;
  };
  filling_ = true;
  x_ = makeBox("tileX");
  y_ = makeBox("tileY");
  turns_ = new QComboBox;
  turns_->setObjectName("tileTurns");
  for (int n = 0; n < 4; ++n) turns_->addItem(QStringLiteral("%1°").arg(90 * n));
  connect(turns_, &QComboBox::currentIndexChanged, this, &TilePanel::takePlace);
  filling_ = false;
  tags_ = new QLabel;
  tags_->setObjectName("tileTags");
  const auto labelFor = [](QWidget* field) {
    auto* label = new QLabel;
    label->setBuddy(field);
    return label;
  };
  serialLabel_ = labelFor(serial_);
  ofTypeLabel_ = new QLabel;
  xLabel_ = labelFor(x_);
  yLabel_ = labelFor(y_);
  turnsLabel_ = labelFor(turns_);
  tagsLabel_ = new QLabel;
  auto* form = new QFormLayout{page};
  form->setContentsMargins(0, 0, 0, 0);
  form->addRow(serialLabel_, serial_);
  form->addRow(ofTypeLabel_, ofType_);
  form->addRow(xLabel_, x_);
  form->addRow(yLabel_, y_);
  form->addRow(turnsLabel_, turns_);
  form->addRow(tagsLabel_, tags_);
  return page;
}

void TilePanel::retranslate() {
  emptyText_->setText(
      tr("Tiles are laid by their type: size, pitch and pattern of the tags. This site has no tile type yet."));
  emptyButton_->setText(tr("Make a tile type…"));
  const auto name = [](QAction* action, const QString& text, const QString& tip) {
    action->setText(text);
    action->setToolTip(tip);
  };
  name(layMode_, tr("Lay tiles"), tr("Lay tiles by dragging over the floor (L)"));
  name(chooseMode_, tr("Choose tiles"), tr("Choose and move tiles (C)"));
  name(turn_, tr("Turn"), tr("Turn what is chosen, else what is laid next (R)"));
  name(duplicate_, tr("Duplicate"), tr("Lay the chosen tiles again beside them (Ctrl+D)"));
  name(delete_, tr("Delete"), tr("Delete the chosen tiles (Del)"));
  alignButton_->setToolTip(tr("Align the chosen tiles"));
  alignButton_->setAccessibleName(tr("Align the chosen tiles"));
  const QStringList lines{tr("Left edges"), tr("Right edges"), tr("Upper edges"), tr("Lower edges"),
                          tr("To the neighbours")};
  for (qsizetype n = 0; n < lines.size(); ++n) alignMenu_->actions().at(n)->setText(lines[n]);
  typeLabel_->setText(tr("Tile type"));
  types_->setText(tr("Tile types…"));
  prefixLabel_->setText(tr("Serials begin with"));
  digitsLabel_->setText(tr("Digits"));
  numberLabel_->setText(tr("Numbers from"));
  nextLabel_->setText(tr("Next tile"));
  serialLabel_->setText(tr("Serial number"));
  ofTypeLabel_->setText(tr("Tile type"));
  xLabel_->setText(tr("Left edge at x"));
  yLabel_->setText(tr("Lower edge at y"));
  for (QDoubleSpinBox* box : {x_, y_}) box->setSuffix(tr(" cm"));
  turnsLabel_->setText(tr("Turned by"));
  tagsLabel_->setText(tr("Tags"));
}

}  // namespace tessera::ui
