#include "ui/commission/commissioning.h"

#include <algorithm>

#include "ui/commission/vehicle_draft.h"

namespace tessera::ui {
namespace {

// Another one for each wizard: two vehicles set up one after the other are two steps.
int freshMergeKey() {
  static int last = 0x434f4d4d;
  return ++last;
}

}  // namespace

Commissioning::Commissioning(FleetLink& link, SiteDocument& document, std::optional<VehicleId> editing, QObject* parent)
    : QObject{parent}, link_{link}, document_{document}, mergeKey_{freshMergeKey()}, picture_{link.latest()} {
  const floor::Site& site = document.site();
  if (editing)
    if (const floor::VehicleSetup* v = document.map()->vehicle(*editing)) editing_ = *v;
  if (editing_) {
    draft_ = *editing_;
  } else {
    draft_ = VehicleDraft::presets(site).front().setup;
    draft_.id = VehicleDraft::freeAddress(site).value_or(VehicleId{});
    draft_.name = VehicleDraft::freeName(site, draft_.id).toStdString();
    draft_.key = VehicleDraft::randomKey();
  }
  connect(&link_, &FleetLink::snapshotChanged, this, [this] {
    picture_ = link_.latest();
    Q_EMIT seen();
  });
}

void Commissioning::setDraft(const floor::VehicleSetup& draft) {
  if (draft == draft_) return;
  draft_ = draft;
  Q_EMIT draftChanged();
}

std::optional<VehicleId> Commissioning::standing() const {
  if (entered_) return entered_->id;
  if (editing_) return editing_->id;
  return std::nullopt;
}

QString Commissioning::complaint() const { return VehicleDraft::complaint(document_.site(), draft_, standing()); }

Result<void> Commissioning::enterAs(VehicleId address, const wire::Key& key) {
  const std::optional<VehicleId> old = standing();
  const floor::VehicleSetup* present = old ? document_.map()->vehicle(*old) : nullptr;
  floor::VehicleSetup entry = draft_;
  entry.id = address;
  entry.key = key;
  selection_.setVehicle(address);
  if (present != nullptr && *present == entry) return {};
  const QString name = QString::fromStdString(draft_.name);
  const auto put = [&](floor::Site& site) {
    const auto at =
        std::find_if(site.vehicles.begin(), site.vehicles.end(), [&](const auto& v) { return v.id == old; });
    if (at == site.vehicles.end())
      site.vehicles.push_back(entry);
    else
      *at = entry;
  };
  if (!entered_) stepsBefore_ = document_.undoStack().index();
  auto done =
      document_.edit(isNew() ? tr("Add vehicle %1").arg(name) : tr("Change vehicle %1").arg(name), put, mergeKey_);
  if (!done) return done;
  entered_ = entry;
  for (const Step step : {Step::Contact, Step::Settings, Step::Readers, Step::Compass, Step::Jog, Step::Drive})
    setMark(step, Mark::Open);
  Q_EMIT siteChanged();
  return {};
}

// By undoing where nothing has been done to the site since, so that no trace is left.
void Commissioning::leave() {
  if (!entered_) return;
  const VehicleId id = entered_->id;
  // Undone, the site would have the key that the vehicle had before.
  const bool keepsKey = paired_ && editing_;
  if (keepsKey) {
    editing_->id = entered_->id;
    editing_->key = entered_->key;
  }
  QUndoStack& stack = document_.undoStack();
  int begin = stack.index();
  while (begin > stepsBefore_ && stack.command(begin - 1)->id() == mergeKey_) --begin;
  if (begin == stepsBefore_ && !keepsKey) {
    stack.setIndex(begin);
  } else {
    const auto taken =
        document_.edit(tr("Take back vehicle %1").arg(QString::fromStdString(entered_->name)), [&](floor::Site& site) {
          const auto at =
              std::find_if(site.vehicles.begin(), site.vehicles.end(), [&](const auto& v) { return v.id == id; });
          if (at == site.vehicles.end()) return;
          if (editing_)
            *at = *editing_;
          else
            site.vehicles.erase(at);
        });
    if (!taken) return;  // it stands as entered: the site would contradict itself without it
  }
  entered_.reset();
  Q_EMIT siteChanged();
}

void Commissioning::setPaired() {
  paired_ = true;
  Q_EMIT pairedChanged();
}

const supervisor::VehicleView* Commissioning::view() const { return picture_ ? picture_->find(address()) : nullptr; }

QString Commissioning::silence() const {
  const QString name = QString::fromStdString(draft_.name);
  if (!picture_) return tr("Not connected. Connect to the vehicles to go on here.");
  if (picture_->port.state != supervisor::PortState::Open)
    return tr("The port is not open. Check the cable and connect anew.");
  const supervisor::VehicleView* vehicle = view();
  if (vehicle == nullptr) return tr("The supervision does not know %1 yet. Wait a moment, or connect anew.").arg(name);
  switch (vehicle->contact) {
    case supervisor::Contact::Connected:
      return {};
    case supervisor::Contact::Calling:
      return tr("Calling %1: no answer yet. Is it switched on, flashed and set to address %2 and this radio channel?")
          .arg(name)
          .arg(address().value);
    case supervisor::Contact::Silent:
      return tr("%1 has fallen silent. Is it still switched on and in reach of the radio?").arg(name);
    case supervisor::Contact::Refused:
      break;
  }
  return tr("%1 answers, but with another key (or another version of the protocol). Go back to the key and pair it, or "
            "type the key that it has.")
      .arg(name);
}

void Commissioning::setMark(Step step, Mark mark) {
  Mark& m = marks_[static_cast<std::size_t>(step)];
  if (m == mark) return;
  m = mark;
  Q_EMIT markChanged();
}

}  // namespace tessera::ui
