#include "ui/help/help_topic.h"

#include <QVariant>
#include <QWidget>

namespace tessera::ui {

QString helpTopicOf(const QWidget* widget) {
  for (; widget != nullptr; widget = widget->parentWidget()) {
    const QString topic = widget->property("helpTopic").toString();
    if (!topic.isEmpty()) return topic;
  }
  return QStringLiteral("start");
}

}  // namespace tessera::ui
