#include "ui/fleet/save_events.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QMessageBox>
#include <QSaveFile>
#include <QStandardPaths>

#include "floor/text_file.h"
#include "ui/base/wording.h"
#include "ui/fleet/event_model.h"
#include "ui/fleet/roles.h"

namespace tessera::ui {
namespace {

QString words(const char* english) { return QCoreApplication::translate("SaveEvents", english); }

QByteArray csvCell(QString text) {
  if (text.contains(QLatin1Char(',')) || text.contains(QLatin1Char('"')) || text.contains(QLatin1Char('\n')))
    text = QLatin1Char('"') + text.replace(QLatin1Char('"'), QLatin1String{"\"\""}) + QLatin1Char('"');
  return text.toUtf8();
}

// Programs read it: the same in every language.
QByteArray severityWord(int severity) {
  switch (static_cast<supervisor::Severity>(severity)) {
    case supervisor::Severity::Info:
      return "info";
    case supervisor::Severity::Warning:
      return "warning";
    case supervisor::Severity::Error:
      break;
  }
  return "error";
}

}  // namespace

QString saveEvents(const QAbstractItemModel& events, const QString& file) {
  const QString failed =
      words(QT_TRANSLATE_NOOP("SaveEvents", "The file %1 could not be written. Choose another folder.")).arg(file);
  if (const auto fit = floor::replaceable(file.toStdString()); !fit) return text(fit.error().sentence);
  QSaveFile out{file};
  if (!out.open(QIODevice::WriteOnly)) return failed;
  out.write("\xEF\xBB\xBFtime,vehicle,severity,what\r\n");
  for (int row = 0; row < events.rowCount(); ++row) {
    const QDateTime when = events.index(row, EventModel::When).data(TimeRole).toDateTime();
    out.write(when.toOffsetFromUtc(when.offsetFromUtc()).toString(Qt::ISODateWithMs).toLatin1() + ',');
    out.write(csvCell(events.index(row, EventModel::Who).data().toString()) + ',');
    out.write(severityWord(events.index(row, EventModel::What).data(SeverityRole).toInt()) + ',');
    out.write(csvCell(events.index(row, EventModel::What).data().toString()) + "\r\n");
  }
  return out.commit() ? QString{} : failed;
}

void askAndSaveEvents(QWidget& parent, const QAbstractItemModel& events, const QString& proposal) {
  const QString title = words(QT_TRANSLATE_NOOP("SaveEvents", "Save the listed events"));
  QFileDialog dialog{&parent, title, QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation),
                     words(QT_TRANSLATE_NOOP("SaveEvents", "Table (*.csv)"))};
  dialog.setObjectName(QStringLiteral("saveEventsDialog"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(QStringLiteral("csv"));
  // Qt's own dialogue: keys pressed in a foreign one would not reach Stop all.
  dialog.setOption(QFileDialog::DontUseNativeDialog);
  dialog.selectFile(proposal);
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
  const QString failed = saveEvents(events, dialog.selectedFiles().front());
  if (failed.isEmpty()) return;
  QMessageBox box{QMessageBox::Warning, title, failed, QMessageBox::Ok, &parent};
  box.setObjectName(QStringLiteral("trouble"));
  box.exec();
}

}  // namespace tessera::ui
