#include "app/tessera/step_log.h"

#include <QStringList>
#include <QUndoStack>
#include <utility>

namespace tessera::desktop {
namespace {

constexpr int kMostNamed = 12;

}  // namespace

StepLog::StepLog(const QUndoStack& steps, QObject* parent) : QObject{parent}, stack_{steps}, index_{steps.index()} {
  connect(&stack_, &QUndoStack::indexChanged, this, &StepLog::follow);
}

void StepLog::follow(int index) {
  while (index_ < index) add({stack_.text(index_++), false});
  while (index_ > index) add({stack_.text(--index_), true});
}

// Done and undone again, or the other way round, it never was. A step that dissolved with its forerunner has no name
// any more: the forerunner goes.
void StepLog::add(Step step) {
  if (!steps_.empty() && steps_.back().undone != step.undone &&
      (steps_.back().name == step.name || (step.undone && step.name.isEmpty()))) {
    steps_.pop_back();
    return;
  }
  if (!step.name.isEmpty()) steps_.push_back(std::move(step));
}

QString StepLog::take() {
  const std::vector<Step> steps = std::exchange(steps_, {});
  QStringList names;
  int more = 0;
  for (std::size_t n = 0; n < steps.size();) {
    std::size_t end = n + 1;
    while (end < steps.size() && steps[end] == steps[n]) ++end;
    const QString name = steps[n].undone ? tr("Undo: %1").arg(steps[n].name) : steps[n].name;
    if (names.size() >= kMostNamed)
      ++more;
    else
      names << (end - n > 1 ? tr("%1 (%2 times)").arg(name).arg(end - n) : name);
    n = end;
  }
  if (more > 0) names << tr("and %n more", nullptr, more);
  return names.join(QStringLiteral(", "));
}

}  // namespace tessera::desktop
