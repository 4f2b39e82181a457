#include "ui/base/site_document.h"

#include <utility>

#include "floor/site_patch.h"

namespace tessera::ui {

// Keeps what differs, not two sites: a day's work on a large floor is thousands of steps.
class EditSite : public QUndoCommand {
public:
  EditSite(SiteDocument& document, const QString& step, floor::SitePatch patch,
           std::shared_ptr<const floor::SiteMap> after, int mergeKey)
      : QUndoCommand{step},
        document_{document},
        patch_{std::move(patch)},
        first_{std::move(after)},
        mergeKey_{mergeKey} {}

  void undo() override { show(back(document_.site())); }
  void redo() override {
    if (first_) return document_.show(std::exchange(first_, nullptr));
    floor::Site site = document_.site();
    patch_.apply(site);
    show(std::move(site));
  }
  [[nodiscard]] int id() const override { return mergeKey_ == 0 ? -1 : mergeKey_; }
  // The document shows what the later step led to.
  bool mergeWith(const QUndoCommand* later) override {
    const auto* edit = dynamic_cast<const EditSite*>(later);
    if (edit == nullptr || edit->mergeKey_ != mergeKey_) return false;
    patch_ = floor::SitePatch{back(edit->back(document_.site())), document_.site()};
    setObsolete(patch_.empty());
    return true;
  }

private:
  [[nodiscard]] floor::Site back(floor::Site site) const {
    patch_.revert(site);
    return site;
  }
  // The site was one like this before, so that it is good again, or as bad as it was opened.
  void show(floor::Site site) {
    auto map = floor::SiteMap::rebuild(std::move(site), *document_.map(), patch_, floor::Ambiguity::Carried);
    if (map) document_.show(*std::move(map));
  }

  SiteDocument& document_;
  floor::SitePatch patch_;
  std::shared_ptr<const floor::SiteMap> first_;  ///< until it is shown for the first time
  int mergeKey_;
};

SiteDocument::SiteDocument(QObject* parent) : QObject{parent}, map_{floor::SiteMap::build({}).value()} {
  connect(&undo_, &QUndoStack::cleanChanged, this, [this](bool clean) { Q_EMIT modifiedChanged(!clean); });
}

void SiteDocument::setPath(const QString& path) {
  if (path == path_) return;
  path_ = path;
  Q_EMIT pathChanged();
}

void SiteDocument::replace(std::shared_ptr<const floor::SiteMap> map, const QString& path) {
  undo_.clear();
  map_ = std::move(map);
  setPath(path);
  Q_EMIT replaced();
  Q_EMIT changed();
}

void SiteDocument::markSaved() { undo_.setClean(); }

Result<void> SiteDocument::edit(const QString& step, const std::function<void(floor::Site&)>& change, int mergeKey) {
  floor::Site after = site();
  change(after);
  floor::SitePatch patch{site(), after};
  if (patch.empty()) return {};
  auto map = floor::SiteMap::rebuild(std::move(after), *map_, patch);
  if (!map) return tl::unexpected{map.error()};
  undo_.push(new EditSite{*this, step, std::move(patch), *std::move(map), mergeKey});
  return {};
}

void SiteDocument::restore(const QString& step, std::shared_ptr<const floor::SiteMap> map) {
  floor::SitePatch patch{site(), map->site()};
  undo_.push(new EditSite{*this, step, std::move(patch), std::move(map), 0});
}

void SiteDocument::show(std::shared_ptr<const floor::SiteMap> map) {
  map_ = std::move(map);
  Q_EMIT changed();
}

}  // namespace tessera::ui
