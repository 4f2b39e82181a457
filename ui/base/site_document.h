// The open site: its values, its look-up map, and every edit as a named step that can be undone.
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <functional>
#include <memory>

#include "base/result.h"
#include "floor/site_map.h"

namespace tessera::ui {

class SiteDocument : public QObject {
  Q_OBJECT
public:
  /// Begins with an empty, unnamed site.
  explicit SiteDocument(QObject* parent = nullptr);

  [[nodiscard]] const floor::Site& site() const { return map_->site(); }
  /// Never null. An edit makes a new one; who holds the old one is not disturbed.
  [[nodiscard]] const std::shared_ptr<const floor::SiteMap>& map() const { return map_; }
  /// Where it was opened or last saved; empty: nowhere yet.
  [[nodiscard]] const QString& path() const { return path_; }
  void setPath(const QString& path);
  [[nodiscard]] QUndoStack& undoStack() { return undo_; }
  [[nodiscard]] bool isModified() const { return !undo_.isClean(); }

  /// Another site takes this one's place; its steps are forgotten.
  void replace(std::shared_ptr<const floor::SiteMap> map, const QString& path);
  /// What stands now is saved.
  void markSaved();
  /// What stands now is in no file, though nothing was edited since replace().
  void markUnsaved() { undo_.resetClean(); }

  /// One step, e.g. edit(tr("Move vertex"), [](Site& s) {...}). Steps in a row with the same mergeKey (0: never) become
  /// one, as in a drag. Error: the site would contradict itself (two routes of one name, ...) where it did not yet;
  /// nothing has changed then. A step keeps what differs, so that thousands of them are cheap on any floor.
  Result<void> edit(const QString& step, const std::function<void(floor::Site&)>& change, int mergeKey = 0);

  /// The whole site becomes another one, as one step.
  void restore(const QString& step, std::shared_ptr<const floor::SiteMap> map);

Q_SIGNALS:
  /// Something in the site is different: opened, edited, undone or redone.
  void changed();
  /// A different site was opened.
  void replaced();
  void pathChanged();
  void modifiedChanged(bool modified);

private:
  friend class EditSite;
  void show(std::shared_ptr<const floor::SiteMap> map);

  std::shared_ptr<const floor::SiteMap> map_;
  QString path_;
  QUndoStack undo_;
};

}  // namespace tessera::ui
