// The host's own E32 on the bench: its parameters read and written over the port on which the vehicles are heard
// otherwise, while the module is in configuration mode (M0 = M1 = 1). Nobody else may have the port open meanwhile.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

#include "base/sentence.h"
#include "floor/site.h"
#include "host/port_choice.h"
#include "link/e32_dialogue.h"

namespace tessera::host {

/// What a site asks of every module on its channel. Error: a value that the module does not have.
[[nodiscard]] Result<link::E32Parameters> radioParametersOf(const floor::RadioSetup& radio);

class RadioModule : public QObject {
  Q_OBJECT
public:
  struct Options {
    /// M0 and M1 hang on the adapter's RTS and DTR. The lines are let go (high on a TTL adapter, mode 3) for the
    /// conversation and taken again after it. A port that cannot switch them says so by notice(); jumpers then do it.
    bool switchLines = false;
  };
  /// port: its baud is not looked at, as configuration goes at 9600. A device server has to be set to 9600 itself.
  explicit RadioModule(const PortChoice& port, Options options, QObject* parent = nullptr);
  explicit RadioModule(const PortChoice& port, QObject* parent = nullptr) : RadioModule{port, Options{}, parent} {}
  ~RadioModule() override;

  /// Each ends in one found() or failed(). While one is under way, further ones are passed over.
  void read();
  /// Writes to the module's lasting memory, reads back and compares.
  void write(const link::E32Parameters& parameters);
  /// Neither found() nor failed() follow.
  void cancel();
  [[nodiscard]] bool busy() const { return dialogue_.has_value(); }
  /// What the module said of itself when it was found; nullopt: it does not tell.
  [[nodiscard]] const std::optional<link::E32Version>& version() const { return version_; }

Q_SIGNALS:
  /// What the module holds now; after write(), that is what was written.
  void found(const tessera::link::E32Parameters& parameters);
  /// What went wrong, and what to try.
  void failed(const tessera::Sentence& sentence);
  /// Something to know that does not end the work.
  void notice(const tessera::Sentence& sentence);

private:
  void begin(link::E32Dialogue dialogue);
  void opened();
  void turn();
  void end();
  void fail(const Sentence& sentence);
  [[nodiscard]] Sentence outcomeSentence() const;

  PortChoice choice_;
  Options options_;
  std::unique_ptr<BytePort> port_;
  std::optional<link::E32Dialogue> dialogue_;
  std::optional<link::E32Version> version_;
  QTimer timer_;
  bool asking_ = false;  ///< the change of mode is over
  bool linesSwitched_ = false;
};

}  // namespace tessera::host
