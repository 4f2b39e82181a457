#include "app/tessera/site_files.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>

#include "app/tessera/wait_cursor.h"
#include "floor/new_floor.h"
#include "floor/site_json.h"
#include "ui/base/wording.h"
#include "ui/connect/new_site_dialog.h"

namespace tessera::desktop {
namespace {

const QString kSuffix = QStringLiteral(".tessera.json");

Result<std::shared_ptr<const floor::SiteMap>> mapFrom(const QString& path) {
  const WaitCursor wait;
  auto site = floor::loadSite(path.toStdString());
  if (!site) return tl::unexpected{site.error()};
  // What contradicts itself is mended in the window.
  return floor::SiteMap::build(*std::move(site), floor::Ambiguity::Carried);
}

}  // namespace

SiteFiles::SiteFiles(ui::SiteDocument& document, Settings& settings, QWidget& window)
    : document_{document}, settings_{settings}, window_{window} {}

Result<QString> SiteFiles::demoPath() {
  const QDir folder{QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)};
  const QString path = folder.filePath(QStringLiteral("demo") + kSuffix);
  if (QFileInfo::exists(path)) return path;
  QFile ours{QStringLiteral(":/sites/demo.tessera.json")};
  if (!folder.mkpath(QStringLiteral(".")) || !ours.copy(path))
    return failure(phrase("Core", "The demo floor could not be put into %1: %2.")
                       .with(folder.path().toStdString(), ours.errorString().toStdString()));
  QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner);
  return path;
}

// Saving is asked for from within dialogues as well.
QWidget* SiteFiles::above() const {
  QWidget* modal = QApplication::activeModalWidget();
  return modal != nullptr ? modal : &window_;
}

bool SiteFiles::open(const QString& path) { return mayLeave() && read(QFileInfo{path}.absoluteFilePath()); }

bool SiteFiles::openAsking() {
  if (!mayLeave()) return false;
  const QString start = document_.path().isEmpty() ? QDir::homePath() : QFileInfo{document_.path()}.path();
  const QString path =
      QFileDialog::getOpenFileName(&window_, tr("Open a site"), start, tr("Sites (*%1);;All files (*)").arg(kSuffix));
  return !path.isEmpty() && read(path);
}

bool SiteFiles::openDemo() {
  const auto path = demoPath();
  if (path) return open(*path);
  tell(tr("The demo floor is not there"), ui::text(path.error().sentence));
  return false;
}

bool SiteFiles::create() {
  if (!mayLeave()) return false;
  ui::NewSiteDialog dialog{&window_};
  if (dialog.exec() != QDialog::Accepted) return false;
  const WaitCursor wait;
  auto site = floor::layNewFloor(dialog.wish());
  auto map = site ? floor::SiteMap::build(*std::move(site)) : tl::unexpected{site.error()};
  if (!map) {
    tell(tr("The site could not be made"), ui::text(map.error().sentence));
    return false;
  }
  document_.replace(*std::move(map), {});
  Q_EMIT opened();
  return true;
}

void SiteFiles::remember(const QString& path, std::shared_ptr<const floor::SiteMap> holds) {
  const QFileInfo file{path};
  seen_ = {path, file.lastModified(), file.size(), std::move(holds)};
}

bool SiteFiles::read(const QString& path) {
  const QFileInfo before{path};
  const Seen seen{path, before.lastModified(), before.size(), nullptr};
  auto map = mapFrom(path);
  if (!map) {
    tell(tr("The site could not be opened"), ui::text(map.error().sentence));
    return false;
  }
  const auto other = sharing_ ? sharing_(path) : std::nullopt;
  if (other && !mayShare(path, *other)) return false;
  // What another copy has not saved is in its hands.
  auto unsaved = recovery_ && !other ? recovery_(path) : nullptr;
  if (unsaved && unsaved->site() == (*map)->site()) unsaved = nullptr;
  // Asked before anything is touched: until there is an answer, both stay as they are.
  const auto answer = unsaved ? askRecovery(path) : Recovery::Forget;
  if (answer == Recovery::Undecided) return false;
  seen_ = seen;
  seen_.holds = *map;
  document_.replace(*map, path);
  settings_.addRecent(path);
  settings_.setSite(path);
  // As one step upon the file's contents, so that it can be looked at, saved or undone like any other.
  if (answer == Recovery::TakeUp)
    document_.restore(tr("Restore unsaved changes"), unsaved);
  else if (unsaved)
    Q_EMIT givenUp(path);
  Q_EMIT opened();
  tellContradictions();
  return true;
}

void SiteFiles::tellContradictions() {
  const floor::Contradictions& all = document_.map()->contradictions();
  if (all.empty() || unattended_) return;
  const QString first = ui::text(all.front().sentence);
  const auto more = static_cast<int>(all.size()) - 1;
  tell(tr("The site contradicts itself"),
       tr("%1 It was opened so that it can be mended: the panel Faults lists what is wrong. Until then no vehicle is "
          "supervised with it.")
           .arg(more == 0 ? first : tr("%1 And %n more.", nullptr, more).arg(first)));
}

bool SiteFiles::mayShare(const QString& path, qint64 process) {
  return unattended_ ||
         ask("sharedQuestion", tr("This site is open already"),
             tr("Another window of Tessera (process %1) has %2 open. Changes made in both overwrite one another.")
                 .arg(process)
                 .arg(QFileInfo{path}.fileName()),
             tr("&Do not open it"), tr("&Open it here as well")) == Recovery::Forget;
}

SiteFiles::Recovery SiteFiles::askRecovery(const QString& path) {
  if (unattended_) return Recovery::TakeUp;
  return ask("recoverQuestion", tr("Unsaved changes were kept"),
             tr("When %1 was open last, the program ended before its changes were saved. Take them up again?")
                 .arg(QFileInfo{path}.fileName()),
             tr("&Take them up"), tr("&Forget them"));
}

SiteFiles::Recovery SiteFiles::ask(const char* name, const QString& title, const QString& question,
                                   const QString& takeUp, const QString& forget) {
  QMessageBox box{QMessageBox::Question, title, question, QMessageBox::NoButton, above()};
  box.setObjectName(QLatin1String{name});
  QAbstractButton* take = box.addButton(takeUp, QMessageBox::AcceptRole);
  QAbstractButton* leave = box.addButton(forget, QMessageBox::DestructiveRole);
  box.setDefaultButton(qobject_cast<QPushButton*>(take));
  box.exec();
  if (box.clickedButton() == take) return Recovery::TakeUp;
  return box.clickedButton() == leave ? Recovery::Forget : Recovery::Undecided;
}

bool SiteFiles::openHomeless() {
  for (const Homeless& kept : homeless_ ? homeless_() : std::vector<Homeless>{}) {
    const QString name = QString::fromStdString(kept.map->site().name);
    switch (ask("homelessQuestion", tr("An unsaved site was kept"),
                tr("The site “%1” was in no file yet when the program ended (%2). Open it again?").arg(name, kept.when),
                tr("&Open it"), tr("&Forget it"))) {
      case Recovery::TakeUp:
        document_.replace(kept.map, {});
        document_.markUnsaved();
        Q_EMIT takenUp(kept.key);
        Q_EMIT opened();
        tellContradictions();
        return true;
      case Recovery::Forget:
        Q_EMIT forgotten(kept.key);
        break;
      case Recovery::Undecided:
        return false;
    }
  }
  return false;
}

bool SiteFiles::save() { return document_.path().isEmpty() ? saveAs() : writeTo(document_.path()); }

bool SiteFiles::saveAs() {
  const QString proposal = document_.path().isEmpty()
                               ? QDir::home().filePath(QString::fromStdString(document_.site().name) + kSuffix)
                               : document_.path();
  QFileDialog dialog{above(), tr("Save the site"), QFileInfo{proposal}.path(), tr("Sites (*%1)").arg(kSuffix)};
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  // By the dialogue, which then asks before a file of that name is replaced.
  dialog.setDefaultSuffix(QString{kSuffix}.mid(1));
  dialog.selectFile(QFileInfo{proposal}.fileName());
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return false;
  QString path = dialog.selectedFiles().constFirst();
  if (path.endsWith(QLatin1String{".json"})) return writeTo(path);
  // A dot in the name was taken for a suffix.
  path += kSuffix;
  const auto replace = [&] {
    return QMessageBox::question(above(), tr("Save the site"),
                                 tr("%1 exists already. Replace it?").arg(QFileInfo{path}.fileName())) ==
           QMessageBox::Yes;
  };
  return (!QFileInfo::exists(path) || replace()) && writeTo(path);
}

SiteFiles::Changed SiteFiles::askChanged(const QString& path) {
  const QFileInfo file{path};
  if (path != seen_.path || !file.exists() || (file.lastModified() == seen_.modified && file.size() == seen_.size))
    return Changed::Overwrite;
  const auto other = mapFrom(path);
  // Touched, or put back from a copy.
  if (other && seen_.holds && (*other)->site() == seen_.holds->site()) return Changed::Overwrite;
  if (!unattended_) {
    const QString name = file.fileName();
    const QString when = QLocale{}.toString(file.lastModified(), QLocale::ShortFormat);
    QMessageBox box{
        QMessageBox::Warning, tr("The file was changed"),
        other
            ? tr("Somebody else has changed %1 since it was opened or saved here (%2). What it holds now is kept as a "
                 "revision if you overwrite it.")
                  .arg(name, when)
            : tr("Somebody else has changed %1 since it was opened or saved here (%2). It can be read no more, so that "
                 "no revision can be kept of it.")
                  .arg(name, when),
        QMessageBox::Cancel, above()};
    box.setObjectName(QStringLiteral("changedQuestion"));
    QAbstractButton* elsewhere = box.addButton(tr("Save under &another name…"), QMessageBox::AcceptRole);
    QAbstractButton* overwrite = box.addButton(tr("&Overwrite it"), QMessageBox::DestructiveRole);
    box.setDefaultButton(qobject_cast<QPushButton*>(elsewhere));
    box.exec();
    if (box.clickedButton() == elsewhere) return Changed::Elsewhere;
    if (box.clickedButton() != overwrite) return Changed::Cancel;
  }
  if (other) Q_EMIT overwriting(*other, file.lastModified());
  return Changed::Overwrite;
}

bool SiteFiles::writeTo(const QString& path) {
  const Changed changed = askChanged(path);
  if (changed != Changed::Overwrite) return changed == Changed::Elsewhere && saveAs();
  const WaitCursor wait;
  if (const auto saved = floor::saveSite(document_.site(), path.toStdString()); !saved) {
    tell(tr("The site could not be saved"), ui::text(saved.error().sentence));
    return false;
  }
  remember(path, document_.map());
  document_.setPath(path);
  document_.markSaved();
  settings_.addRecent(path);
  settings_.setSite(path);
  Q_EMIT saved(path);
  return true;
}

bool SiteFiles::mayLeave() {
  if (!document_.isModified()) return true;
  QMessageBox box{
      QMessageBox::Question, tr("Save the changes?"),
      tr("The site “%1” has changes that are not saved.").arg(QString::fromStdString(document_.site().name)),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, above()};
  box.setObjectName(QStringLiteral("saveQuestion"));
  box.setDefaultButton(QMessageBox::Save);
  switch (box.exec()) {
    case QMessageBox::Save:
      return save();
    case QMessageBox::Discard:
      Q_EMIT givenUp(document_.path());
      return true;
    default:
      return false;
  }
}

void SiteFiles::offerToSaveKey(const QString& vehicle) {
  QMessageBox box{QMessageBox::Warning, tr("Save the vehicle's key?"),
                  tr("%1 obeys nobody but who has its new key, and no file has it yet. Save the site?").arg(vehicle),
                  QMessageBox::Save, above()};
  box.setObjectName(QStringLiteral("saveKeyQuestion"));
  QAbstractButton* later = box.addButton(tr("&Later"), QMessageBox::RejectRole);
  box.setDefaultButton(QMessageBox::Save);
  box.exec();
  if (box.clickedButton() != nullptr && box.clickedButton() != later) save();
}

void SiteFiles::tell(const QString& title, const QString& sentence) {
  QMessageBox box{QMessageBox::Warning, title, sentence, QMessageBox::Ok, above()};
  box.setObjectName(QStringLiteral("trouble"));
  box.exec();
}

}  // namespace tessera::desktop
