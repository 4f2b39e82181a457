#include "app/tessera/register_notes.h"

#include <QCryptographicHash>
#include <algorithm>

namespace tessera::desktop {
namespace {

constexpr int kForms = 4;
constexpr int kOrders = 3;

QString wordOf(const scan::PlaceName& place) {
  return QString::number(place.tag) + QLatin1Char{' '} + QString::fromStdString(place.serial);
}

std::optional<scan::PlaceName> placeOf(const QString& word) {
  bool isNumber = false;
  const qulonglong tag = word.section(QLatin1Char{' '}, 0, 0).toULongLong(&isNumber);
  const QString serial = word.section(QLatin1Char{' '}, 1);
  if (!isNumber || serial.isEmpty()) return std::nullopt;
  return scan::PlaceName{serial.toStdString(), static_cast<std::size_t>(tag)};
}

// A site goes by its key in the database; a path is too long and too odd for the name of a group.
QString groupOf(const QByteArray& key) {
  const auto hash = QCryptographicHash::hash(key, QCryptographicHash::Sha1);
  return QStringLiteral("register/sites/") + QString::fromLatin1(hash.toHex().left(16)) + QLatin1Char{'/'};
}

}  // namespace

QString RegisterNotes::group() const { return groupOf(QByteArray::fromStdString(keeper_.key())); }

void RegisterNotes::takeFrom(const QString& key) {
  const QString before = groupOf(key.toUtf8());
  for (const char* name : {"order", "tile", "again", "at", "skipped"})
    if (store_.contains(before + name)) store_.setValue(group() + name, store_.value(before + name));
  store_.remove(before.chopped(1));
  store_.sync();
}

ui::ReaderChoice RegisterNotes::reader() const {
  ui::ReaderChoice reader;
  reader.keyboard = store_.value("register/reader/keyboard", reader.keyboard).toBool();
  reader.port = store_.value("register/reader/port").toString();
  reader.baud = store_.value("register/reader/baud", reader.baud).toInt();
  reader.form = static_cast<scan::ReaderForm>(std::clamp(store_.value("register/reader/form").toInt(), 0, kForms - 1));
  reader.sounds = store_.value("register/sounds", reader.sounds).toBool();
  return reader;
}

void RegisterNotes::setReader(const ui::ReaderChoice& reader) {
  store_.setValue("register/reader/keyboard", reader.keyboard);
  store_.setValue("register/reader/port", reader.port);
  store_.setValue("register/reader/baud", reader.baud);
  store_.setValue("register/reader/form", static_cast<int>(reader.form));
  store_.setValue("register/sounds", reader.sounds);
}

std::optional<scan::Course> RegisterNotes::course() const {
  const QString at = group();
  if (!store_.contains(at + "order")) return std::nullopt;
  scan::Course course;
  course.order = static_cast<scan::WalkOrder>(std::clamp(store_.value(at + "order").toInt(), 0, kOrders - 1));
  course.tile = store_.value(at + "tile").toString().toStdString();
  course.again = store_.value(at + "again").toBool();
  course.at = placeOf(store_.value(at + "at").toString());
  for (const QString& word : store_.value(at + "skipped").toStringList())
    if (const auto place = placeOf(word)) course.skipped.push_back(*place);
  return course;
}

void RegisterNotes::keep(const std::optional<scan::Course>& course) {
  const QString at = group();
  if (!course) {
    store_.remove(at.chopped(1));
  } else {
    QStringList skipped;
    for (const scan::PlaceName& place : course->skipped) skipped << wordOf(place);
    store_.setValue(at + "order", static_cast<int>(course->order));
    store_.setValue(at + "tile", QString::fromStdString(course->tile));
    store_.setValue(at + "again", course->again);
    store_.setValue(at + "at", course->at ? wordOf(*course->at) : QString{});
    store_.setValue(at + "skipped", skipped);
  }
  store_.sync();
  keeper_.keepNow();
}

}  // namespace tessera::desktop
