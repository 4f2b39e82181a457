#include "app/tessera/exchange_files.h"

#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

#include "app/tessera/wait_cursor.h"
#include "exchange/file_format.h"
#include "exchange/lif.h"
#include "exchange/site_import.h"
#include "exchange/tag_tables.h"
#include "floor/json_node.h"
#include "floor/text_file.h"
#include "ui/base/wording.h"
#include "ui/exchange/changes_dialog.h"
#include "ui/print/map_picture.h"
#include "ui/print/map_picture_dialog.h"

namespace tessera::desktop {
namespace {

const QString kTable = QStringLiteral(".csv");
const QString kPlaceTable = QStringLiteral(".places.csv");
const QString kLayout = QStringLiteral(".lif.json");

Result<exchange::Preview> previewOf(const floor::Site& onto, const QString& path) {
  const WaitCursor wait;
  const std::string file = path.toStdString();
  const auto text = floor::loadText(file, floor::kMostJson + 1);
  if (!text) return tl::unexpected{text.error()};
  switch (exchange::formatOf(file, *text)) {
    case exchange::Format::TagTable:
      return exchange::importTags(onto, *text, file);
    case exchange::Format::Layout:
      return exchange::importLif(onto, *text, file);
    case exchange::Format::Site:
      break;
  }
  return exchange::importSite(onto, *text, file);
}

}  // namespace

ExchangeFiles::ExchangeFiles(ui::SiteDocument& document, QWidget& window) : document_{document}, window_{window} {}

QString ExchangeFiles::proposal(const QString& suffix) const {
  QString name = QString::fromStdString(document_.site().name);
  if (name.isEmpty()) name = QStringLiteral("site");
  name.replace(QLatin1Char('/'), QLatin1Char('-'));
  const QDir folder = document_.path().isEmpty() ? QDir::home() : QFileInfo{document_.path()}.dir();
  return folder.filePath(name + suffix);
}

void ExchangeFiles::importAsking() {
  const QString path =
      QFileDialog::getOpenFileName(&window_, tr("Import"), QFileInfo{proposal({})}.path(),
                                   tr("Tables of tags, layouts and sites (*.csv *.lif *.json);;All files (*)"));
  if (!path.isEmpty()) importFrom(path);
}

bool ExchangeFiles::importFrom(const QString& path) {
  const auto preview = previewOf(document_.site(), path);
  const QString name = QFileInfo{path}.fileName();
  if (!preview) {
    tell(tr("The file could not be imported"), ui::text(preview.error().sentence));
    return false;
  }
  ui::ChangesDialog dialog{*preview, name, &window_};
  if (dialog.exec() != QDialog::Accepted) return false;
  const auto done = document_.edit(tr("Import %1").arg(name), [&](floor::Site& site) { site = preview->site; });
  if (!done) tell(tr("The file could not be imported"), ui::text(done.error().sentence));
  return done.has_value();
}

void ExchangeFiles::exportAsking() {
  const QString table = tr("Table of the tiles' tags (*%1)").arg(kTable);
  const QString places = tr("Table of all tags with their places (*%1)").arg(kPlaceTable);
  const QString layout = tr("Layout of routes and stations, VDMA LIF (*%1)").arg(kLayout);
  QString chosen = table;
  QString path = QFileDialog::getSaveFileName(&window_, tr("Export"), proposal(kTable),
                                              QStringList{table, places, layout}.join(QStringLiteral(";;")), &chosen);
  if (path.isEmpty()) return;
  // The dialogue's proposal keeps its ending when another format is chosen.
  const QString suffix = chosen == layout ? kLayout : chosen == places ? kPlaceTable : kTable;
  if (!path.endsWith(suffix)) {
    if (path.endsWith(kTable)) path.chop(kTable.size());
    path += suffix;
    if (QFileInfo::exists(path) &&
        QMessageBox::question(&window_, tr("Export"),
                              tr("%1 exists already. Replace it?").arg(QFileInfo{path}.fileName())) != QMessageBox::Yes)
      return;
  }
  exportTo(path);
}

bool ExchangeFiles::exportTo(const QString& path) {
  const floor::Site& site = document_.site();
  exchange::LifText written;
  if (path.endsWith(kPlaceTable))
    written = {exchange::writeTagPlaces(site), exchange::leftOutOfTagPlaces(site)};
  else if (path.endsWith(kTable))
    written = {exchange::writeTileTags(site), exchange::leftOutOfTileTags(site)};
  else
    written = exchange::writeLif(site, QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString());
  const auto saved = floor::saveText(written.text, path.toStdString(), floor::Replacing::Allowed);
  if (!saved) {
    tell(tr("The file could not be written"), ui::text(saved.error().sentence));
    return false;
  }
  Q_EMIT told(tr("%1 was written.").arg(QFileInfo{path}.fileName()));
  if (written.leftOut.empty()) return true;
  QStringList lines;
  for (const Sentence& sentence : written.leftOut) lines << ui::text(sentence);
  QMessageBox box{QMessageBox::Information, tr("Exported"),
                  tr("%1 was written. What the format cannot carry:").arg(QFileInfo{path}.fileName()), QMessageBox::Ok,
                  &window_};
  box.setObjectName(QStringLiteral("exportNotes"));
  box.setInformativeText(lines.join(QLatin1Char('\n')));
  box.exec();
  return true;
}

void ExchangeFiles::savePictureAsking(bool planShown) {
  ui::MapPictureDialog dialog{document_.map(), planShown, &window_};
  if (dialog.exec() != QDialog::Accepted) return;
  QString path = QFileDialog::getSaveFileName(&window_, tr("Save the picture"), proposal(QStringLiteral(".pdf")),
                                              tr("Pictures (*.pdf *.svg *.png)"));
  if (path.isEmpty()) return;
  if (QFileInfo{path}.suffix().isEmpty()) path += QStringLiteral(".pdf");
  const auto saved = [&] {
    const WaitCursor wait;
    return ui::saveSheet(ui::MapSheet{document_.map(), dialog.wish()}, path);
  }();
  if (!saved) return tell(tr("The picture could not be saved"), ui::text(saved.error().sentence));
  Q_EMIT told(tr("%1 was written.").arg(QFileInfo{path}.fileName()));
}

void ExchangeFiles::tell(const QString& title, const QString& sentence) {
  QMessageBox box{QMessageBox::Warning, title, sentence, QMessageBox::Ok, &window_};
  box.setObjectName(QStringLiteral("exchangeTrouble"));
  box.exec();
}

}  // namespace tessera::desktop
