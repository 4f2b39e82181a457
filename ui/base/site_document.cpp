#include "ui/base/site_document.h"

#include <utility>

namespace tessera::ui {

// Both maps are kept whole: they are immutable and what an edit leaves alone could be shared between them.
class EditSite : public QUndoCommand {
public:
  EditSite(SiteDocument& document, const QString& step, std::shared_ptr<const floor::SiteMap> after, int mergeKey)
      : QUndoCommand{step},
        document_{document},
        before_{document.map()},
        after_{std::move(after)},
        mergeKey_{mergeKey} {}

  void undo() override { document_.show(before_); }
  void redo() override { document_.show(after_); }
  [[nodiscard]] int id() const override { return mergeKey_ == 0 ? -1 : mergeKey_; }
  bool mergeWith(const QUndoCommand* later) override {
    const auto* edit = dynamic_cast<const EditSite*>(later);
    if (edit == nullptr || edit->mergeKey_ != mergeKey_) return false;
    after_ = edit->after_;
    setObsolete(before_->site() == after_->site());
    return true;
  }

private:
  SiteDocument& document_;
  std::shared_ptr<const floor::SiteMap> before_;
  std::shared_ptr<const floor::SiteMap> after_;
  int mergeKey_;
};

class EditSiteLightly : public QUndoCommand {
public:
  using Change = std::function<void(floor::Site&)>;

  EditSiteLightly(SiteDocument& document, const QString& step, std::shared_ptr<const floor::SiteMap> after,
                  Change change, Change back)
      : QUndoCommand{step},
        document_{document},
        first_{std::move(after)},
        change_{std::move(change)},
        back_{std::move(back)} {}

  void undo() override { go(back_); }
  void redo() override {
    if (first_)
      document_.show(std::exchange(first_, nullptr));
    else
      go(change_);
  }

private:
  void go(const Change& change) {
    floor::Site site = document_.site();
    change(site);
    // The site was one like this before, so that it is good again.
    if (auto map = floor::SiteMap::build(std::move(site))) document_.show(*std::move(map));
  }

  SiteDocument& document_;
  std::shared_ptr<const floor::SiteMap> first_;
  Change change_;
  Change back_;
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
  if (after == site()) return {};
  auto map = floor::SiteMap::build(std::move(after));
  if (!map) return tl::unexpected{map.error()};
  undo_.push(new EditSite{*this, step, *std::move(map), mergeKey});
  return {};
}

Result<void> SiteDocument::editLightly(const QString& step, std::function<void(floor::Site&)> change,
                                       std::function<void(floor::Site&)> back) {
  floor::Site after = site();
  change(after);
  if (after == site()) return {};
  auto map = floor::SiteMap::build(std::move(after));
  if (!map) return tl::unexpected{map.error()};
  undo_.push(new EditSiteLightly{*this, step, *std::move(map), std::move(change), std::move(back)});
  return {};
}

void SiteDocument::restore(const QString& step, std::shared_ptr<const floor::SiteMap> map) {
  undo_.push(new EditSite{*this, step, std::move(map), 0});
}

void SiteDocument::show(std::shared_ptr<const floor::SiteMap> map) {
  map_ = std::move(map);
  Q_EMIT changed();
}

}  // namespace tessera::ui
