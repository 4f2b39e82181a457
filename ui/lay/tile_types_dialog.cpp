#include "ui/lay/tile_types_dialog.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QEvent>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>

#include "floor/new_floor.h"
#include "floor/type_change.h"
#include "ui/base/wording.h"
#include "ui/lay/type_form.h"
#include "ui/lay/type_picture.h"

namespace tessera::ui {

TileTypesDialog::TileTypesDialog(SiteDocument& document, QWidget* parent) : QDialog{parent}, document_{document} {
  setObjectName("tileTypesDialog");
  setProperty("helpTopic", QStringLiteral("tiles"));
  for (const floor::TileType& type : document_.site().tileTypes) drafts_.push_back({type.name, type});
  question_ = [this](const QString& sentence) {
    QMessageBox box{QMessageBox::Warning, windowTitle(), sentence, QMessageBox::NoButton, this};
    box.setObjectName("dropUids");
    const auto* go = box.addButton(tr("Change the types"), QMessageBox::AcceptRole);
    box.setDefaultButton(box.addButton(tr("Go back"), QMessageBox::RejectRole));
    box.exec();
    return box.clickedButton() == go;
  };
  build();
  for (const Draft& draft : drafts_) list_->addItem(QString::fromStdString(draft.type.name));
  retranslate();
  list_->setCurrentRow(drafts_.empty() ? -1 : 0);
  showCurrent();
}

void TileTypesDialog::showType(const std::string& type) {
  for (std::size_t n = 0; n < drafts_.size(); ++n)
    if (drafts_[n].type.name == type) list_->setCurrentRow(static_cast<int>(n));
}

int TileTypesDialog::current() const {
  const int row = list_->currentRow();
  return row < static_cast<int>(drafts_.size()) ? row : -1;
}

std::string TileTypesDialog::freeName(const std::string& stem) const {
  for (int n = 1;; ++n) {
    std::string name = n == 1 ? stem : stem + " (" + std::to_string(n) + ")";
    if (std::none_of(drafts_.begin(), drafts_.end(), [&](const Draft& d) { return d.type.name == name; })) return name;
  }
}

void TileTypesDialog::add(floor::TileType type) {
  type.name = freeName(type.name);
  drafts_.push_back({{}, type});
  list_->addItem(QString::fromStdString(type.name));
  list_->setCurrentRow(list_->count() - 1);
  form_->editName();
}

void TileTypesDialog::duplicate() {
  if (const int at = current(); at >= 0) add(drafts_[static_cast<std::size_t>(at)].type);
}

void TileTypesDialog::remove() {
  const int at = current();
  if (at < 0) return;
  const Draft& draft = drafts_[static_cast<std::size_t>(at)];
  const std::size_t tiles = draft.was.empty() ? 0 : floor::useOf(document_.site(), draft.was).tiles;
  if (tiles > 0) {
    fault_->setText(tr("%n tile(s) are of this type: delete them first.", nullptr, static_cast<int>(tiles)));
    return;
  }
  drafts_.erase(drafts_.begin() + at);
  delete list_->takeItem(at);
  showCurrent();
}

void TileTypesDialog::showCurrent() {
  const int at = current();
  editor_->setVisible(at >= 0);
  empty_->setVisible(at < 0);
  duplicate_->setEnabled(at >= 0);
  delete_->setEnabled(at >= 0);
  if (at >= 0) form_->setType(drafts_[static_cast<std::size_t>(at)].type);
  showSentences();
}

void TileTypesDialog::showSentences() {
  QString first;
  for (const Draft& draft : drafts_) {
    const QString fault = faultOf(draft);
    if (first.isEmpty() && !fault.isEmpty()) first = fault;
  }
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(first.isEmpty());
  fault_->setText(first);
  const int at = current();
  if (at < 0) return;
  const Draft& draft = drafts_[static_cast<std::size_t>(at)];
  picture_->setType(draft.type);
  seams_->setText(seamText(draft.type));
  use_->setText(useText(draft));
}

QString TileTypesDialog::faultOf(const Draft& draft) const {
  if (const auto good = floor::checkTileType(draft.type); !good) return text(good.error().sentence);
  const auto called = std::count_if(drafts_.begin(), drafts_.end(),
                                    [&](const Draft& other) { return other.type.name == draft.type.name; });
  return called > 1 ? tr("There are two tile types “%1”.").arg(QString::fromStdString(draft.type.name)) : QString{};
}

// By way of names that nobody else has: two types may have changed their names with each other.
void TileTypesDialog::applyTo(floor::Site& site) const {
  std::erase_if(site.tileTypes, [&](const floor::TileType& type) {
    return std::none_of(drafts_.begin(), drafts_.end(), [&](const Draft& d) { return d.was == type.name; });
  });
  const auto passing = [](std::size_t n) { return "\n" + std::to_string(n); };
  for (std::size_t n = 0; n < drafts_.size(); ++n) {
    if (drafts_[n].was.empty()) continue;
    floor::TileType type = drafts_[n].type;
    type.name = passing(n);
    floor::changeTileType(site, drafts_[n].was, type);
  }
  for (std::size_t n = 0; n < drafts_.size(); ++n) {
    if (drafts_[n].was.empty()) {
      site.tileTypes.push_back(drafts_[n].type);
    } else {
      floor::changeTileType(site, passing(n), drafts_[n].type);
    }
  }
}

void TileTypesDialog::accept() {
  std::size_t dropped = 0;
  for (const Draft& draft : drafts_) {
    if (!faultOf(draft).isEmpty()) return;
    if (!draft.was.empty()) dropped += floor::foresee(document_.site(), draft.was, draft.type).dropped;
  }
  if (dropped > 0 && !question_(tr("%n registered tag(s) lie where the changed types have none: their numbers would "
                                   "be dropped from the site.",
                                   nullptr, static_cast<int>(dropped))))
    return;
  const auto done = document_.edit(tr("Change tile types"), [this](floor::Site& site) { applyTo(site); });
  if (!done) {
    fault_->setText(text(done.error().sentence));
    return;
  }
  QDialog::accept();
}

void TileTypesDialog::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    retranslate();
    showSentences();
  }
  QDialog::changeEvent(event);
}

}  // namespace tessera::ui
