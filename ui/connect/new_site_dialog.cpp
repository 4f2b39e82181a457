#include "ui/connect/new_site_dialog.h"

#include <QEvent>
#include <QFormLayout>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

namespace tessera::ui {

NewSiteDialog::NewSiteDialog(QWidget* parent)
    : QDialog{parent}, buttons_{QDialogButtonBox::Ok | QDialogButtonBox::Cancel} {
  setObjectName(QStringLiteral("newSiteDialog"));
  name_.setObjectName(QStringLiteral("siteName"));
  type_.setObjectName(QStringLiteral("tileType"));
  columns_.setObjectName(QStringLiteral("columns"));
  rows_.setObjectName(QStringLiteral("rows"));
  empty_.setObjectName(QStringLiteral("emptyFloor"));
  practice_.setObjectName(QStringLiteral("practice"));
  for (std::size_t i = 0; i < floor::usualTileTypes().size(); ++i) type_.addItem({});
  for (QSpinBox* box : {&columns_, &rows_}) box->setRange(1, floor::NewFloor::kMost);
  columns_.setValue(5);
  rows_.setValue(4);
  practiceHint_.setWordWrap(true);
  const std::pair<QLabel*, QWidget*> rows[]{{&nameLabel_, &name_},
                                            {&typeLabel_, &type_},
                                            {&columnsLabel_, &columns_},
                                            {&rowsLabel_, &rows_},
                                            {&sizeLabel_, &size_}};
  auto* form = new QFormLayout;
  for (const auto& [label, field] : rows) {
    label->setBuddy(field);
    form->addRow(label, field);
  }
  auto* layout = new QVBoxLayout{this};
  layout->addLayout(form);
  layout->addWidget(&empty_);
  layout->addWidget(&practice_);
  layout->addWidget(&practiceHint_);
  layout->addStretch();
  layout->addWidget(&buttons_);
  connect(&buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(&buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(&type_, &QComboBox::currentIndexChanged, this, &NewSiteDialog::showSize);
  connect(&columns_, &QSpinBox::valueChanged, this, &NewSiteDialog::showSize);
  connect(&rows_, &QSpinBox::valueChanged, this, &NewSiteDialog::showSize);
  connect(&empty_, &QCheckBox::toggled, this, &NewSiteDialog::showSize);
  connect(&empty_, &QCheckBox::toggled, this, [this](bool empty) {
    for (QWidget* field : std::initializer_list<QWidget*>{&columns_, &rows_, &practice_, &practiceHint_})
      field->setEnabled(!empty);
  });
  retranslate();
  name_.setText(tr("My floor"));
  name_.selectAll();
}

floor::NewFloor NewSiteDialog::wish() const {
  const QString name = name_.text().trimmed();
  const auto& type = floor::usualTileTypes()[static_cast<std::size_t>(std::max(0, type_.currentIndex()))];
  const std::string called = (name.isEmpty() ? tr("My floor") : name).toStdString();
  if (empty_.isChecked()) return {called, type, 0, 0, false};
  return {called, type, columns_.value(), rows_.value(), practice_.isChecked()};
}

void NewSiteDialog::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QDialog::changeEvent(event);
}

void NewSiteDialog::retranslate() {
  setWindowTitle(tr("New site"));
  nameLabel_.setText(tr("&Name:"));
  typeLabel_.setText(tr("&Tiles:"));
  columnsLabel_.setText(tr("Tiles &across (x):"));
  rowsLabel_.setText(tr("Tiles &up (y):"));
  sizeLabel_.setText(tr("Size:"));
  empty_.setText(tr("&Empty floor: the tiles are laid by hand afterwards"));
  practice_.setText(tr("&Practice floor: tags with made-up UIDs, for simulated vehicles"));
  practiceHint_.setText(
      tr("Made-up UIDs for all tags, and one vehicle, so that you can try everything in the simulated world. On a real "
         "floor leave this off: its tags get their UIDs when they are registered, and made-up ones are in the way."));
  const QLocale locale;
  int i = 0;
  for (const floor::TileType& t : floor::usualTileTypes()) {
    const auto cm = [&](Metres length) { return locale.toString(std::lround(length.value() * 100.0)); };
    const QString pattern = t.pattern == floor::Pattern::Full ? tr("every place") : tr("every second place");
    type_.setItemText(i++, tr("%1 × %2 cm, a tag each %3 cm, %4").arg(cm(t.width), cm(t.height), cm(t.pitch), pattern));
  }
  buttons_.button(QDialogButtonBox::Ok)->setText(tr("&Make the site"));
  buttons_.button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
  showSize();
}

void NewSiteDialog::showSize() {
  const QLocale locale;
  const auto w = wish();
  const auto metres = [&](int count, Metres one) { return locale.toString(count * one.value(), 'f', 2); };
  if (w.columns == 0) return size_.setText(tr("no tiles yet"));
  const int tags = w.columns * w.rows * static_cast<int>(floor::tagOffsets(w.type).size());
  size_.setText(
      tr("%1 × %2 m, %n tag(s)", nullptr, tags).arg(metres(w.columns, w.type.width), metres(w.rows, w.type.height)));
}

}  // namespace tessera::ui
