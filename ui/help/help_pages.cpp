#include "ui/help/help_pages.h"

#include <QFile>
#include <algorithm>

namespace tessera::ui {
namespace {

QString readHelp(const QString& folder, const QString& topic) {
  QFile file{QStringLiteral(":/help/%1/%2.md").arg(folder, topic)};
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString{};
}

// Of "# Title" on the first line.
QString titleOf(const QString& text) {
  QString line = text.section(QLatin1Char('\n'), 0, 0).trimmed();
  while (line.startsWith(QLatin1Char('#'))) line.remove(0, 1);
  return line.trimmed();
}

}  // namespace

const std::vector<QString>& HelpPages::topics() {
  static const std::vector<QString> kTopics{
      "start",         "floor",       "tiles",   "floorplan", "zones",     "checking", "drivecheck",     "routes",
      "registering",   "vehicles",    "running", "charts",    "locating",  "events",   "connecting",     "radio",
      "commissioning", "calibrating", "compass", "exchange",  "revisions", "keyboard", "troubleshooting"};
  return kTopics;
}

HelpPages::HelpPages() : folder_{tr("en", "folder of the help pages in this language: en or zh_CN")} {
  for (const QString& topic : topics()) {
    QString text = readHelp(folder_, topic);
    if (text.isEmpty()) text = readHelp(QStringLiteral("en"), topic);
    pages_.push_back({topic, titleOf(text), text});
  }
}

const HelpPage& HelpPages::page(const QString& topic) const {
  const auto at = std::find_if(pages_.begin(), pages_.end(), [&](const HelpPage& p) { return p.topic == topic; });
  return at == pages_.end() ? pages_.front() : *at;
}

QUrl HelpPages::url(const QString& topic) const {
  const bool own = QFile::exists(QStringLiteral(":/help/%1/%2.md").arg(folder_, page(topic).topic));
  return QUrl{QStringLiteral("qrc:/help/%1/%2.md").arg(own ? folder_ : QStringLiteral("en"), page(topic).topic)};
}

std::vector<const HelpPage*> HelpPages::search(const QString& words) const {
  const QStringList wanted = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
  const auto holds = [&](const QString& text) {
    return std::all_of(wanted.begin(), wanted.end(),
                       [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
  };
  std::vector<const HelpPage*> hits;
  for (const HelpPage& p : pages_)
    if (holds(p.text)) hits.push_back(&p);
  std::stable_partition(hits.begin(), hits.end(), [&](const HelpPage* p) { return holds(p->title); });
  return hits;
}

}  // namespace tessera::ui
