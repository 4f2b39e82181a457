// Has the open site checked after every edit, beside the window, and keeps the newest verdict.
#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "sitecheck/live/check_thread.h"
#include "ui/base/site_document.h"

namespace tessera::ui {

class FaultWatch : public QObject {
  Q_OBJECT
public:
  /// The document must outlive it.
  explicit FaultWatch(SiteDocument& document, QObject* parent = nullptr);

  /// The newest that there is; while isChecking() of the site as it was.
  [[nodiscard]] const sitecheck::Verdict& verdict() const { return verdict_; }
  [[nodiscard]] bool isChecking() const { return checked_ != wanted_.site || options_ != wanted_.options; }
  /// Room that vehicles are to keep around them.
  [[nodiscard]] Metres clearance() const { return wanted_.options.clearance; }
  void setClearance(Metres clearance);
  /// A route as it would be, while it is drawn or dragged; nullopt: none any more.
  void tryRoute(std::optional<floor::Route> route);

Q_SIGNALS:
  /// The verdict is another, or a check has begun.
  void changed();
  /// Of the route that is tried; empty when none is, or nothing is wrong with it.
  void routeTried(const tessera::sitecheck::Faults& faults);

private:
  void order();
  void take();

  SiteDocument& document_;
  sitecheck::CheckOrder wanted_;
  std::shared_ptr<const floor::Site> checked_;
  sitecheck::CheckOptions options_;  ///< with which it was checked
  sitecheck::Verdict verdict_;
  bool another_ = false;           ///< a site was opened; what is still found of the one before is of no use
  sitecheck::CheckThread thread_;  // last: nothing comes from it once the others go
};

}  // namespace tessera::ui
