// Compares two states of a site beside the window's thread. What is asked for while one comparison runs comes next;
// what was overtaken is dropped.
#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <memory>

#include "ui/history/comparison.h"

namespace tessera::ui {

class Comparer : public QObject {
  Q_OBJECT
public:
  explicit Comparer(QObject* parent = nullptr);

  void compare(std::shared_ptr<const floor::SiteMap> before, std::shared_ptr<const floor::SiteMap> after);
  /// Nothing is wanted any more.
  void drop();
  [[nodiscard]] bool isComparing() const { return wanted_; }

Q_SIGNALS:
  /// Of what was asked for last.
  void compared(const std::shared_ptr<const tessera::ui::Comparison>& comparison);

private:
  void start();
  void take();

  QFutureWatcher<std::shared_ptr<const Comparison>> watcher_;
  std::shared_ptr<const floor::SiteMap> before_;
  std::shared_ptr<const floor::SiteMap> after_;
  bool wanted_ = false;
};

}  // namespace tessera::ui
