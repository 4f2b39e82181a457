// The widgets of the tile types' dialogue and what it says in words.
#include <QAction>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QMenu>
#include <QPushButton>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>

#include "floor/new_floor.h"
#include "floor/seam.h"
#include "floor/type_change.h"
#include "ui/base/icon.h"
#include "ui/lay/tile_types_dialog.h"
#include "ui/lay/type_form.h"
#include "ui/lay/type_picture.h"

namespace tessera::ui {
namespace {

QString inCentimetresText(Metres length) { return QLocale().toString(std::round(length.value() * 1e3) / 10.0); }

QLabel* makeSentence(const char* name) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setWordWrap(true);
  return label;
}

}  // namespace

void TileTypesDialog::build() {
  bar_ = new QToolBar;
  const int side = fontMetrics().height() + 2;
  bar_->setIconSize({side, side});
  add_ = new QToolButton;
  add_->setObjectName("addType");
  add_->setIcon(icon("add"));
  add_->setPopupMode(QToolButton::InstantPopup);
  addMenu_ = new QMenu{this};
  addMenu_->setObjectName("addTypeMenu");
  add_->setMenu(addMenu_);
  bar_->addWidget(add_);
  duplicate_ = bar_->addAction(icon("duplicate"), {}, this, &TileTypesDialog::duplicate);
  duplicate_->setObjectName("duplicateType");
  delete_ = bar_->addAction(icon("delete"), {}, this, &TileTypesDialog::remove);
  delete_->setObjectName("deleteType");
  list_ = new QListWidget;
  list_->setObjectName("typeList");
  connect(list_, &QListWidget::currentRowChanged, this, [this] {
    if (!filling_) showCurrent();
  });
  form_ = new TypeForm;
  picture_ = new TypePicture;
  connect(form_, &TypeForm::edited, this, [this] {
    const int at = current();
    if (at < 0) return;
    drafts_[static_cast<std::size_t>(at)].type = form_->type();
    list_->item(at)->setText(QString::fromStdString(form_->type().name));
    showSentences();
  });
  connect(picture_, &TypePicture::placeToggled, form_, &TypeForm::togglePlace);
  seams_ = makeSentence("seamSentence");
  use_ = makeSentence("useSentence");
  fault_ = makeSentence("typeFault");
  empty_ = makeSentence("noTypes");
  empty_->setAlignment(Qt::AlignCenter);
  buttons_ = new QDialogButtonBox{QDialogButtonBox::Ok | QDialogButtonBox::Cancel};
  connect(buttons_, &QDialogButtonBox::accepted, this, &TileTypesDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &TileTypesDialog::reject);

  auto* left = new QVBoxLayout;
  left->setSpacing(0);
  left->addWidget(bar_);
  left->addWidget(list_, 1);
  auto* drawing = new QVBoxLayout;
  drawing->addWidget(picture_, 1);
  drawing->addWidget(seams_);
  editor_ = new QWidget;
  auto* editing = new QHBoxLayout{editor_};
  editing->setContentsMargins(0, 0, 0, 0);
  auto* numbers = new QVBoxLayout;
  numbers->addWidget(form_);
  numbers->addWidget(use_);
  numbers->addStretch();
  editing->addLayout(numbers);
  editing->addLayout(drawing, 1);
  auto* middle = new QHBoxLayout;
  middle->addLayout(left, 1);
  middle->addWidget(editor_, 4);
  middle->addWidget(empty_, 4);
  auto* layout = new QVBoxLayout{this};
  layout->addLayout(middle, 1);
  layout->addWidget(fault_);
  layout->addWidget(buttons_);
  list_->setMinimumWidth(fontMetrics().averageCharWidth() * 22);
  resize(fontMetrics().averageCharWidth() * 130, fontMetrics().height() * 28);
}

void TileTypesDialog::fillAddMenu() {
  addMenu_->clear();
  const QLocale locale;
  for (const floor::TileType& type : floor::usualTileTypes()) {
    const auto cm = [&](Metres length) { return locale.toString(std::lround(length.value() * 100.0)); };
    const QString pattern = type.pattern == floor::Pattern::Full ? tr("every place") : tr("every second place");
    const QString text =
        tr("%1 × %2 cm, a tag each %3 cm, %4").arg(cm(type.width), cm(type.height), cm(type.pitch), pattern);
    addMenu_->addAction(text, this, [this, type] { add(type); });
  }
}

void TileTypesDialog::retranslate() {
  setWindowTitle(tr("Tile types"));
  fillAddMenu();
  add_->setToolTip(tr("Add a tile type"));
  add_->setAccessibleName(tr("Add a tile type"));
  duplicate_->setText(tr("Duplicate"));
  duplicate_->setToolTip(tr("Make another type of the same numbers"));
  delete_->setText(tr("Delete"));
  delete_->setToolTip(tr("Delete the type"));
  list_->setAccessibleName(tr("Tile types"));
  empty_->setText(tr("There is no tile type yet. Add one with + : the usual sizes are ready made."));
  buttons_->button(QDialogButtonBox::Ok)->setText(tr("OK"));
  buttons_->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
}

QString TileTypesDialog::seamText(const floor::TileType& type) const {
  if (type.columns < 1 || type.rows < 1) return {};
  const floor::Seam right = floor::seamOf(type, floor::Side::Right);
  const floor::Seam above = floor::seamOf(type, floor::Side::Above);
  const auto sentence = [&](const floor::Seam& seam, const QString& even, const QString& closer, const QString& wider) {
    const QString pitch = inCentimetresText(seam.pitch);
    switch (seam.fit) {
      case floor::Seam::Fit::Even:
        return even.arg(pitch);
      case floor::Seam::Fit::Closer:
        return closer.arg(pitch, inCentimetresText(type.pitch));
      case floor::Seam::Fit::Wider:
        break;
    }
    return wider.arg(pitch, inCentimetresText(type.pitch));
  };
  QStringList sentences{sentence(right, tr("To the right the places go on evenly, %1 cm over the seam."),
                                 tr("To the right they come closer: %1 cm over the seam instead of %2 cm."),
                                 tr("To the right they lie wider: %1 cm over the seam instead of %2 cm.")),
                        sentence(above, tr("Above they go on evenly, %1 cm over the seam."),
                                 tr("Above they come closer: %1 cm over the seam instead of %2 cm."),
                                 tr("Above they lie wider: %1 cm over the seam instead of %2 cm."))};
  if (!right.meeting.empty() || !above.meeting.empty()) {
    const Metres apart = right.meeting.empty()   ? above.apart
                         : above.meeting.empty() ? right.apart
                                                 : std::min(right.apart, above.apart);
    sentences
        << tr("Red: tags meet at the seam, %1 cm apart, closer than within the tile.").arg(inCentimetresText(apart));
  }
  return sentences.join(QLatin1Char(' '));
}

QString TileTypesDialog::useText(const Draft& draft) const {
  if (draft.was.empty()) return tr("A new type: no tile is of it yet.");
  const floor::TypeUse use = floor::useOf(document_.site(), draft.was);
  if (use.tiles == 0) return tr("No tile is of this type.");
  QString text = tr("%n tile(s) are of this type,", nullptr, static_cast<int>(use.tiles)) + QLatin1Char(' ') +
                 tr("%n tag(s) on them are registered.", nullptr, static_cast<int>(use.registered));
  const floor::TypeChange change = floor::foresee(document_.site(), draft.was, draft.type);
  if (change.dropped > 0) {
    text += QLatin1Char(' ') + tr("%n of their numbers would be dropped.", nullptr, static_cast<int>(change.dropped));
  } else if (use.registered > 0) {
    text += QLatin1Char(' ') + tr("All their numbers stay.");
  }
  return text;
}

}  // namespace tessera::ui
