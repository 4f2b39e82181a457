// What all pages of the wizard share: the vehicle as it shall be, how it stands in the site, how it is seen on the air,
// and which steps were done.
#pragma once

#include <QObject>
#include <array>
#include <memory>
#include <optional>

#include "ui/base/fleet_link.h"
#include "ui/base/selection.h"
#include "ui/base/site_document.h"

namespace tessera::ui {

class Commissioning : public QObject {
  Q_OBJECT
public:
  enum class Step { Firmware, Key, Contact, Settings, Readers, Compass, Jog, Drive };
  static constexpr std::size_t kSteps = 8;
  enum class Mark { Open, Done, Skipped };

  /// editing: a vehicle of the site; nullopt: a new one.
  Commissioning(FleetLink& link, SiteDocument& document, std::optional<VehicleId> editing, QObject* parent = nullptr);

  [[nodiscard]] FleetLink& link() { return link_; }
  [[nodiscard]] SiteDocument& document() { return document_; }
  /// The wizard's own choice of vehicle, for what works on the chosen one.
  [[nodiscard]] Selection& selection() { return selection_; }
  [[nodiscard]] bool isNew() const { return !editing_; }
  /// Under which address the vehicle stands in the site: what was entered, else what is edited; nullopt: not yet.
  [[nodiscard]] std::optional<VehicleId> standing() const;
  /// Under which it is called now: standing(), else the draft's.
  [[nodiscard]] VehicleId address() const { return standing().value_or(draft_.id); }

  [[nodiscard]] const floor::VehicleSetup& draft() const { return draft_; }
  void setDraft(const floor::VehicleSetup& draft);
  /// One sentence that says what keeps the draft out of the site; empty: nothing.
  [[nodiscard]] QString complaint() const;

  /// Puts the draft into the site, as one step; nothing when it stands there so already. Error: the site's sentence.
  Result<void> enter() { return enterAs(draft_.id, draft_.key); }
  /// The same with the address and key that the vehicle has before it has taken the draft's.
  Result<void> enterAs(VehicleId address, const wire::Key& key);
  [[nodiscard]] bool entered() const { return entered_.has_value(); }
  /// Takes it out again, or gives the edited one its old shape back; address and key that a paired one has by now stay.
  void leave();
  /// The vehicle has taken the key under which it stands in the site: nobody else knows it.
  [[nodiscard]] bool paired() const { return paired_; }
  void setPaired();

  /// How supervision sees the vehicle; null when it does not. Valid until the next snapshotChanged().
  [[nodiscard]] const supervisor::VehicleView* view() const;
  /// One sentence that says why the vehicle cannot be reached now; empty: it can.
  [[nodiscard]] QString silence() const;
  [[nodiscard]] bool supervised() const { return picture_ != nullptr; }

  [[nodiscard]] Mark mark(Step step) const { return marks_[static_cast<std::size_t>(step)]; }
  void setMark(Step step, Mark mark);

Q_SIGNALS:
  void draftChanged();
  void markChanged();
  /// The site has another vehicle than before: supervision must begin anew.
  void siteChanged();
  /// view() and silence() may be different.
  void seen();
  /// What paired() tells.
  void pairedChanged();

private:
  FleetLink& link_;
  SiteDocument& document_;
  Selection selection_;
  std::optional<floor::VehicleSetup> editing_;  ///< as it was
  floor::VehicleSetup draft_;
  std::optional<floor::VehicleSetup> entered_;
  int mergeKey_;         ///< going back and forth in one wizard stays one step of the document
  int stepsBefore_ = 0;  ///< of the document, when the vehicle was entered
  bool paired_ = false;
  std::shared_ptr<const supervisor::Snapshot> picture_;
  std::array<Mark, kSteps> marks_{};
};

}  // namespace tessera::ui
