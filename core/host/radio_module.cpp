#include "host/radio_module.h"

#include <algorithm>
#include <cmath>

#include "host/supervisor_thread.h"

namespace tessera::host {
namespace {

using Outcome = link::E32Dialogue::Outcome;

constexpr qint32 kConfigureBaud = 9600;
constexpr std::chrono::milliseconds kModeChange{100};  // after the lines: AUX is not seen here
// One failure to open is enough to tell a person; a longer pause than anybody waits keeps the port from trying on.
constexpr RetryPauses kOnce{std::chrono::hours{1}, std::chrono::hours{1}};

}  // namespace

Result<link::E32Parameters> radioParametersOf(const floor::RadioSetup& radio) {
  return link::e32ParametersFor(radio.channel, radio.airRate, radio.baud);
}

RadioModule::RadioModule(const PortChoice& port, Options options, QObject* parent)
    : QObject{parent}, choice_{port.atBaud(kConfigureBaud)}, options_{options}, timer_{this} {
  choice_.pauses = kOnce;
  timer_.setSingleShot(true);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &RadioModule::turn);
}

RadioModule::~RadioModule() { end(); }

void RadioModule::read() {
  if (!busy()) begin(link::E32Dialogue{});
}

void RadioModule::write(const link::E32Parameters& parameters) {
  if (busy()) return;
  auto dialogue = link::E32Dialogue::writing(parameters);
  if (!dialogue) {
    Q_EMIT failed(Sentence{dialogue.error().sentence});
    return;
  }
  begin(std::move(*dialogue));
}

void RadioModule::cancel() { end(); }

void RadioModule::begin(link::E32Dialogue dialogue) {
  dialogue_ = std::move(dialogue);
  version_.reset();
  port_ = makePort(choice_);
  // Queued: whoever hears failed() may ask again at once, and the port must not be deleted within its own signal.
  const auto queued = Qt::QueuedConnection;
  connect(port_.get(), &BytePort::opened, this, &RadioModule::opened, queued);
  connect(
      port_.get(), &BytePort::lost, this,
      [this](const Sentence& reason) {
        fail(phrase("Core", "The port %1 cannot be used: %2.").with(choice_.text().toStdString(), reason));
      },
      queued);
  connect(
      port_.get(), &BytePort::received, this,
      [this](const QByteArray& bytes) {
        if (!asking_) return;  // what comes while the mode changes is no answer
        const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.constData());
        dialogue_->ingest({data, static_cast<std::size_t>(bytes.size())}, steadyNow());
        turn();
      },
      queued);
  port_->open();
}

void RadioModule::opened() {
  if (!dialogue_) return;
  if (options_.switchLines) {
    linesSwitched_ = true;
    if (!port_->setLines(false, false))
      Q_EMIT notice(phrase("Core", "The lines RTS and DTR of %1 cannot be switched: set M0 and M1 by jumpers.")
                        .with(choice_.text().toStdString()));
  }
  timer_.start(kModeChange);
}

void RadioModule::turn() {
  if (!dialogue_ || !port_->isOpen()) return;
  asking_ = true;
  const std::vector<std::uint8_t> bytes = dialogue_->poll(steadyNow());
  if (!bytes.empty() && !port_->write(bytes)) return;  // lost() tells the rest
  if (dialogue_->outcome() == Outcome::Running) {
    const double pause = std::clamp((dialogue_->wake() - steadyNow()).value(), 0.0, 10.0);
    timer_.start(std::chrono::milliseconds{static_cast<int>(std::ceil(pause * 1000.0))});
    return;
  }
  if (dialogue_->outcome() != Outcome::Done) return fail(outcomeSentence());
  const link::E32Parameters parameters = *dialogue_->parameters();
  version_ = dialogue_->version();
  end();
  Q_EMIT found(parameters);
}

void RadioModule::end() {
  timer_.stop();
  asking_ = false;
  dialogue_.reset();
  if (!port_) return;
  if (linesSwitched_) port_->setLines(true, true);
  linesSwitched_ = false;
  port_->disconnect(this);
  port_->close();
  port_.release()->deleteLater();
}

void RadioModule::fail(const Sentence& sentence) {
  if (!dialogue_) return;
  end();
  Q_EMIT failed(sentence);
}

Sentence RadioModule::outcomeSentence() const {
  const std::string port = choice_.text().toStdString();
  const bool served = std::holds_alternative<PortChoice::Tcp>(choice_.to);
  const Sentence server =
      served ? Sentence{phrase("Core", " The device server must speak 9600 baud, 8N1, for this.")} : Sentence{""};
  switch (dialogue_->outcome()) {
    case Outcome::Silent:
      return phrase("Core",
                    "The radio module on %1 does not answer: set M0 and M1 to 1 (on most boards by taking both jumpers "
                    "off), check its power and that TXD and RXD are crossed, then try again.%2")
          .with(port, server);
    case Outcome::Garbled:
      return phrase(
                 "Core",
                 "Bytes come from %1, but the radio module does not answer: it seems to be in normal mode. Set M0 and "
                 "M1 to 1 (on most boards by taking both jumpers off), then try again.%2")
          .with(port, server);
    default:
      return phrase("Core",
                    "The radio module on %1 answers, but did not keep what was written: try again; if it stays like "
                    "that, replace the module.")
          .with(port);
  }
}

}  // namespace tessera::host
