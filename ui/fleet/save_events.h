// The events of a list as a file for spreadsheets.
#pragma once

#include <QAbstractItemModel>
#include <QString>

class QWidget;

namespace tessera::ui {

/// CSV (RFC 4180) in UTF-8 with the mark by which spreadsheets know it: time, vehicle, severity, what. Empty: done;
/// otherwise one sentence that says why not.
[[nodiscard]] QString saveEvents(const QAbstractItemModel& events, const QString& file);

/// Asks for a file and saves there; a failure is told.
void askAndSaveEvents(QWidget& parent, const QAbstractItemModel& events, const QString& proposal);

}  // namespace tessera::ui
