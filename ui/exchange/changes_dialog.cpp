#include "ui/exchange/changes_dialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/base/wording.h"

namespace tessera::ui {
namespace {

// A table of a million tags changes as many tiles as it names; nobody reads more of them than this.
constexpr std::size_t kMostShown = 5000;

}  // namespace

QString ChangesDialog::totalsOf(const sitediff::Changes& changes) {
  using sitediff::ChangeKind;
  const auto count = [&](ChangeKind kind) {
    return static_cast<int>(std::count_if(changes.begin(), changes.end(),
                                          [&](const sitediff::Change& change) { return change.kind == kind; }));
  };
  QStringList parts;
  if (const int n = count(ChangeKind::Added)) parts << tr("%Ln new", nullptr, n);
  if (const int n = count(ChangeKind::Changed)) parts << tr("%Ln changed", nullptr, n);
  if (const int n = count(ChangeKind::Moved)) parts << tr("%Ln moved", nullptr, n);
  if (const int n = count(ChangeKind::Removed)) parts << tr("%Ln removed", nullptr, n);
  return parts.join(tr(", ", "between totals"));
}

ChangesDialog::ChangesDialog(const exchange::Preview& preview, const QString& file, QWidget* parent) : QDialog{parent} {
  setObjectName(QStringLiteral("changesDialog"));
  setProperty("helpTopic", QStringLiteral("exchange"));
  setWindowTitle(tr("Import %1").arg(file));
  auto* column = new QVBoxLayout{this};
  const std::size_t count = preview.changes.size();
  auto* head =
      new QLabel{count == 0 ? tr("The file says what the site has already: nothing would change.")
                            : tr("%Ln changes: %1. They are made all together, as one step that can be undone.",
                                 nullptr, static_cast<int>(count))
                                  .arg(totalsOf(preview.changes))};
  head->setObjectName(QStringLiteral("changesHead"));
  head->setWordWrap(true);
  column->addWidget(head);
  auto* list = new QListWidget;
  list->setObjectName(QStringLiteral("changesList"));
  list->setAccessibleName(tr("Changes"));
  list->setSelectionMode(QAbstractItemView::NoSelection);
  list->setWordWrap(true);
  for (std::size_t n = 0; n < std::min(count, kMostShown); ++n) list->addItem(text(preview.changes[n].sentence));
  if (count > kMostShown) list->addItem(tr("and %n more", nullptr, static_cast<int>(count - kMostShown)));
  list->setVisible(count > 0);
  column->addWidget(list, 2);
  if (!preview.notes.empty()) {
    column->addWidget(new QLabel{tr("Please note:")});
    auto* notes = new QListWidget;
    notes->setObjectName(QStringLiteral("changesNotes"));
    notes->setAccessibleName(tr("Please note:"));
    notes->setSelectionMode(QAbstractItemView::NoSelection);
    notes->setWordWrap(true);
    for (const Sentence& note : preview.notes) notes->addItem(text(note));
    column->addWidget(notes, 1);
  }
  if (count == 0) column->addStretch(1);
  auto* buttons = new QDialogButtonBox;
  if (count > 0) {
    auto* take = buttons->addButton(tr("&Import"), QDialogButtonBox::AcceptRole);
    take->setObjectName(QStringLiteral("changesTake"));
    take->setDefault(true);
    buttons->addButton(QDialogButtonBox::Cancel);
  } else {
    buttons->addButton(QDialogButtonBox::Close);
  }
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(buttons);
  const int line = fontMetrics().height();
  resize(34 * line, count > 0 ? 24 * line : 10 * line);
}

}  // namespace tessera::ui
