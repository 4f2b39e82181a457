// Revisions, joined: each saving becomes one, the panel lists them, the floor shows what differs.
#pragma once

#include <QObject>
#include <QPointer>

#include "app/tessera/keeper.h"
#include "app/tessera/settings.h"
#include "app/tessera/step_log.h"
#include "ui/history/revision_panel.h"

namespace tessera::desktop {

/// The person's name as the system has it.
[[nodiscard]] QString systemUser();

class RevisionDesk : public QObject {
  Q_OBJECT
public:
  /// All must outlive it.
  RevisionDesk(ui::SiteDocument& document, Keeper& keeper, Settings& settings, QWidget& window);
  ~RevisionDesk() override;

  /// To be put into a dock.
  [[nodiscard]] ui::RevisionPanel& panel() { return *panel_; }
  /// The site was saved to its file. After Keeper::onSaved().
  void onSaved();
  /// Somebody else saved this into the site's file, which is about to be overwritten.
  void keepOther(const std::shared_ptr<const floor::SiteMap>& other, const QDateTime& when);

private:
  void onOpened();
  void refresh();
  void exportTo(const floor::Site& site, const QDateTime& when);

  ui::SiteDocument& document_;
  Keeper& keeper_;
  Settings& settings_;
  QWidget& window_;
  StepLog steps_;
  QPointer<ui::RevisionPanel> panel_;
  quint64 list_ = 0;
  quint64 load_ = 0;
  qint64 wanted_ = 0;  // the revision that is being read
};

}  // namespace tessera::desktop
