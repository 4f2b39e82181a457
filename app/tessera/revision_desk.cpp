#include "app/tessera/revision_desk.h"

#include <pwd.h>
#include <unistd.h>

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

#include "app/tessera/wait_cursor.h"
#include "floor/site_json.h"
#include "ui/base/wording.h"

namespace tessera::desktop {
namespace {

const QString kSiteFile = QStringLiteral(".tessera.json");

ui::RevisionLine lineOf(const store::Revision& revision) {
  return {revision.id,
          QDateTime::fromMSecsSinceEpoch(revision.note.savedUtcMs),
          QString::fromStdString(revision.note.who),
          QString::fromStdString(revision.note.what),
          revision.note.found,
          revision.changed};
}

}  // namespace

QString systemUser() {
  const passwd* user = ::getpwuid(::getuid());
  if (user == nullptr) return qEnvironmentVariable("USER");
  // The first field of its comment is the full name, where somebody has entered one.
  const QString name = QString::fromLocal8Bit(user->pw_gecos).section(QLatin1Char{','}, 0, 0).trimmed();
  return name.isEmpty() ? QString::fromLocal8Bit(user->pw_name) : name;
}

RevisionDesk::RevisionDesk(ui::SiteDocument& document, Keeper& keeper, Settings& settings, QWidget& window)
    : document_{document},
      keeper_{keeper},
      settings_{settings},
      window_{window},
      steps_{document.undoStack()},
      panel_{new ui::RevisionPanel{document}} {
  panel_->setAuthor(settings_.author(), systemUser());
  connect(&document_, &ui::SiteDocument::replaced, this, &RevisionDesk::onOpened);
  connect(&keeper_, &Keeper::recovered, this, &RevisionDesk::refresh);
  connect(&keeper_, &Keeper::revisionsListed, this,
          [this](quint64 request, const std::vector<store::Revision>& revisions) {
            if (request != list_) return;
            std::vector<ui::RevisionLine> lines;
            for (const store::Revision& revision : revisions) lines.push_back(lineOf(revision));
            panel_->setRevisions(std::move(lines));
          });
  connect(&keeper_, &Keeper::revisionLoaded, this,
          [this](quint64 request, const std::shared_ptr<const floor::SiteMap>& map) {
            if (request == load_) panel_->setRevision(wanted_, map);
          });
  connect(&keeper_, &Keeper::requestFailed, this, [this](quint64 request, const QString& sentence) {
    if (request == load_) panel_->setRevisionTrouble(wanted_, sentence);
  });
  connect(panel_, &ui::RevisionPanel::revisionWanted, this, [this](qint64 id) {
    wanted_ = id;
    load_ = keeper_.loadRevision(id);
    if (load_ == 0) panel_->setRevisionTrouble(id, tr("It cannot be read just now. Try again in a moment."));
  });
  connect(panel_, &ui::RevisionPanel::authorChanged, this, [this](const QString& name) { settings_.setAuthor(name); });
  connect(
      panel_, &ui::RevisionPanel::exportWanted, this,
      [this](const std::shared_ptr<const floor::SiteMap>& map, const QDateTime& when) { exportTo(map->site(), when); });
}

RevisionDesk::~RevisionDesk() { delete panel_; }

// What somebody else wrote into the file, or an earlier version of the program, must not be lost with the next saving.
void RevisionDesk::onOpened() {
  steps_.forget();
  if (!document_.path().isEmpty())
    keeper_.addRevision({QFileInfo{document_.path()}.lastModified().toMSecsSinceEpoch(), "", "", true});
  refresh();
}

void RevisionDesk::onSaved() {
  const QString who = settings_.author().isEmpty() ? systemUser() : settings_.author();
  keeper_.addRevision({QDateTime::currentMSecsSinceEpoch(), who.toStdString(), steps_.take().toStdString(), false});
  refresh();
}

void RevisionDesk::keepOther(const std::shared_ptr<const floor::SiteMap>& other, const QDateTime& when) {
  keeper_.addRevision({when.toMSecsSinceEpoch(), "", tr("Saved by somebody else").toStdString(), false}, other);
}

void RevisionDesk::refresh() { list_ = keeper_.listRevisions(); }

void RevisionDesk::exportTo(const floor::Site& site, const QDateTime& when) {
  const QFileInfo file{document_.path()};
  const QString proposal = file.dir().filePath(file.fileName().section(kSiteFile, 0, 0) + QLatin1Char{' '} +
                                               when.toString(QStringLiteral("yyyy-MM-dd HHmmss")) + kSiteFile);
  QString path = QFileDialog::getSaveFileName(&window_, tr("Save the revision as a file"), proposal,
                                              tr("Sites (*%1)").arg(kSiteFile));
  if (path.isEmpty()) return;
  const auto tell = [this](const QString& sentence) {
    QMessageBox box{QMessageBox::Warning, tr("The revision could not be saved"), sentence, QMessageBox::Ok, &window_};
    box.setObjectName(QStringLiteral("revisionTrouble"));
    box.exec();
  };
  if (!path.endsWith(QLatin1String{".json"})) {
    path += kSiteFile;
    if (QFileInfo::exists(path)) return tell(tr("%1 exists already. Choose another name.").arg(path));
  }
  // The open site's own file is not overwritten behind its back.
  if (QFileInfo{path} == QFileInfo{document_.path()})
    return tell(tr("%1 is the open site's file. Choose another name.").arg(path));
  const auto saved = [&] {
    const WaitCursor wait;
    return floor::saveSite(site, path.toStdString());
  }();
  if (!saved) tell(ui::text(saved.error().sentence));
}

}  // namespace tessera::desktop
