#include "app/tessera/radio_workbench.h"

#include <utility>

#include "host/supervisor_thread.h"
#include "ui/base/wording.h"

namespace tessera::desktop {

RadioWorkbench::RadioWorkbench(FleetSession& session, const ui::ConnectionChoice& choice, const floor::RadioSetup& site)
    : session_{session}, simulated_{choice.kind == ui::ConnectionChoice::Kind::Demo} {
  if (const auto wanted = host::radioParametersOf(site)) findings_.site = *wanted;
  look(session_.latest().get());
  const auto port = session_.rest().value_or(portChoiceOf(choice, choice.port, site.baud));
  // In the simulated world nobody else can set the jumpers.
  if (simulated_) session_.tellWorld("jumpers 1 1");
  module_ = std::make_unique<host::RadioModule>(port);
  connect(module_.get(), &host::RadioModule::found, this, [this](const link::E32Parameters& parameters) {
    if (std::exchange(writing_, false))
      findings_.moduleChanged(parameters);
    else
      findings_.module = parameters;
    Q_EMIT found(parameters);
  });
  connect(module_.get(), &host::RadioModule::failed, this,
          [this](const Sentence& sentence) { Q_EMIT failed(ui::text(sentence)); });
}

RadioWorkbench::~RadioWorkbench() {
  module_.reset();
  if (simulated_) session_.tellWorld("jumpers 0 0");
  session_.resume();
}

void RadioWorkbench::read() { module_->read(); }

void RadioWorkbench::write(const link::E32Parameters& parameters) {
  writing_ = true;
  module_->write(parameters);
}

// It may have been written all the same; what it holds now is told by the next read.
void RadioWorkbench::cancel() { module_->cancel(); }

QStringList RadioWorkbench::advice() const {
  QStringList lines;
  for (const Sentence& sentence : link::radioAdvice(findings_)) lines << ui::text(sentence);
  return lines;
}

void RadioWorkbench::look(const supervisor::Snapshot* snapshot) {
  if (snapshot == nullptr) return;
  findings_.listened = session_.liveFor();
  findings_.damaged = snapshot->channel.noiseSinceHeard;
  findings_.foreign = snapshot->channel.foreignSinceHeard;
  for (const auto& vehicle : snapshot->vehicles) {
    findings_.wrongKey = findings_.wrongKey || vehicle.contact == supervisor::Contact::Refused;
    if (vehicle.link.lastHeard && (!findings_.lastHeard || vehicle.link.age < *findings_.lastHeard))
      findings_.lastHeard = vehicle.link.age;
  }
}

}  // namespace tessera::desktop
