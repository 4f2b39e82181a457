#include "ui/history/comparer.h"

#include <QPromise>
#include <QThreadPool>
#include <utility>

namespace tessera::ui {

Comparer::Comparer(QObject* parent) : QObject{parent} {
  connect(&watcher_, &QFutureWatcherBase::finished, this, &Comparer::take);
}

void Comparer::compare(std::shared_ptr<const floor::SiteMap> before, std::shared_ptr<const floor::SiteMap> after) {
  before_ = std::move(before);
  after_ = std::move(after);
  wanted_ = true;
  if (!watcher_.isRunning()) start();
}

void Comparer::drop() {
  wanted_ = false;
  before_.reset();
  after_.reset();
}

void Comparer::start() {
  auto promise = std::make_shared<QPromise<std::shared_ptr<const Comparison>>>();
  promise->start();
  watcher_.setFuture(promise->future());
  QThreadPool::globalInstance()->start([promise, before = before_, after = after_] {
    promise->addResult(std::make_shared<const Comparison>(ui::compare(before, after)));
    promise->finish();
  });
}

void Comparer::take() {
  if (!wanted_) return;
  const auto comparison = watcher_.result();
  if (comparison->before != before_ || comparison->after != after_) return start();
  wanted_ = false;
  Q_EMIT compared(comparison);
}

}  // namespace tessera::ui
