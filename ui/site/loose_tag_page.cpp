#include "ui/site/loose_tag_page.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/base/icon.h"
#include "ui/base/number_delegate.h"

namespace tessera::ui {

LooseTagPage::LooseTagPage(std::vector<floor::LooseTag> tags, QWidget* parent)
    : QWidget{parent}, model_{std::move(tags)} {
  table_.setObjectName(QStringLiteral("looseTags"));
  add_.setObjectName(QStringLiteral("addLooseTag"));
  remove_.setObjectName(QStringLiteral("removeLooseTag"));
  refusal_.setObjectName(QStringLiteral("looseTagRefusal"));
  add_.setIcon(icon(QStringLiteral("add")));
  remove_.setIcon(icon(QStringLiteral("remove")));
  what_.setWordWrap(true);
  table_.setModel(&model_);
  table_.setSelectionBehavior(QAbstractItemView::SelectRows);
  table_.setSelectionMode(QAbstractItemView::SingleSelection);
  table_.setTabKeyNavigation(false);
  table_.horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_.horizontalHeader()->setHighlightSections(false);
  constexpr double kFarthest = LooseTagModel::kFarthest;
  for (const auto& [column, name] : {std::pair{LooseTagModel::X, "looseX"}, {LooseTagModel::Y, "looseY"}})
    table_.setItemDelegateForColumn(column, new NumberDelegate{{name, 3, -kFarthest, kFarthest, 0.01}, &table_});
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(&add_);
  buttons->addWidget(&remove_);
  buttons->addStretch();
  auto* layout = new QVBoxLayout{this};
  layout->addWidget(&what_);
  layout->addWidget(&table_);
  layout->addWidget(&refusal_);
  layout->addLayout(buttons);

  connect(&add_, &QPushButton::clicked, this, &LooseTagPage::add);
  connect(&remove_, &QPushButton::clicked, this, &LooseTagPage::remove);
  connect(&model_, &LooseTagModel::refused, &refusal_,
          [this](const QString& sentence) { refusal_.show(Notice::Tone::Error, sentence); });
  connect(&model_, &LooseTagModel::edited, this, [this] {
    refusal_.clear();
    offerWhatCanBeDone();
    Q_EMIT edited();
  });
  connect(table_.selectionModel(), &QItemSelectionModel::currentChanged, this, &LooseTagPage::offerWhatCanBeDone);
  offerWhatCanBeDone();
}

void LooseTagPage::add() {
  const QModelIndex index = model_.index(model_.add(), LooseTagModel::Uid);
  table_.setCurrentIndex(index);
  table_.setFocus();
  table_.edit(index);
}

void LooseTagPage::remove() {
  const int row = table_.currentIndex().row();
  model_.remove(row);
  if (model_.rowCount() > 0) table_.setCurrentIndex(model_.index(std::min(row, model_.rowCount() - 1), 0));
}

void LooseTagPage::offerWhatCanBeDone() { remove_.setEnabled(table_.currentIndex().isValid()); }

void LooseTagPage::retranslate() {
  what_.setText(
      tr("Single tags in the floor that belong to no tile, for instance at a station. Their places are those on the "
         "floor, x to the right and y upwards."));
  add_.setText(tr("&Add a tag"));
  remove_.setText(tr("&Remove the tag"));
  model_.retranslate();
}

}  // namespace tessera::ui
