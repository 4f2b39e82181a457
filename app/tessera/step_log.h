// Which steps were done, and undone, since the site was saved last: what a revision says of itself.
#pragma once

#include <QObject>
#include <QString>
#include <vector>

class QUndoStack;

namespace tessera::desktop {

class StepLog : public QObject {
  Q_OBJECT
public:
  /// The stack must outlive it.
  explicit StepLog(const QUndoStack& steps, QObject* parent = nullptr);

  /// "Move tiles (3 times), Undo: Draw a route"; empty: none. What it gives is forgotten.
  [[nodiscard]] QString take();
  void forget() { steps_.clear(); }

private:
  struct Step {
    QString name;
    bool undone = false;
    bool operator==(const Step&) const = default;
  };
  void follow(int index);
  void add(Step step);

  const QUndoStack& stack_;
  std::vector<Step> steps_;
  int index_;
};

}  // namespace tessera::desktop
