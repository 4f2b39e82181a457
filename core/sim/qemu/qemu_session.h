// One life of an emulated vehicle: the emulator, the thread that serves it, and what hangs on its pins.
#pragma once

#include <array>
#include <atomic>
#include <future>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "sim/qemu/pin_logic.h"
#include "sim/qemu/qemu_host.h"
#include "sim/qemu/qemu_link.h"
#include "sim/qemu/qemu_process.h"

namespace tessera::sim {

class QemuHost::Session {
public:
  Session(const QemuConfig& config, const Signals& signals);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Waits until the board runs or has failed to.
  [[nodiscard]] Result<void> ready();
  void set(const Signals& signals);
  void send(firmware::Uart port, std::span<const std::uint8_t> bytes);
  [[nodiscard]] Actions take();
  [[nodiscard]] bool running() const { return running_; }
  [[nodiscard]] std::string trouble() const;
  [[nodiscard]] int resets() const { return resets_; }
  [[nodiscard]] int processId() const { return processId_; }

private:
  enum Port : std::size_t { A, C, D, E, kPorts };

  void run();
  [[nodiscard]] Result<void> open();
  [[nodiscard]] Result<void> findPorts();
  [[nodiscard]] Result<void> serve();
  void takeOver();
  void publish();
  void onTrace(const TraceEvent& event);
  void onPin(Port port, unsigned pin, bool high);

  [[nodiscard]] Result<void> showAllInputs();
  [[nodiscard]] Result<void> showRadioReady();
  void showField(Seconds now);
  /// One step of each wheel's encoder at most. True when more are due.
  [[nodiscard]] Result<bool> stepEncoders();
  [[nodiscard]] Result<void> serveEchoes();
  [[nodiscard]] Seconds restUntilNextWork(Seconds now, bool stepsDue) const;
  [[nodiscard]] std::string pinCommand(Port port, unsigned pin, bool high) const;
  [[nodiscard]] std::vector<std::string> encoderCommands(std::size_t wheel, unsigned before, unsigned levels) const;
  [[nodiscard]] std::string withReason(const std::string& sentence) const;

  const QemuConfig config_;

  // Between the owner's thread and this session's, under the lock.
  mutable std::mutex mutex_;
  Signals newSignals_;
  std::vector<std::uint8_t> radioIn_, readersIn_;
  Actions actions_;
  std::string trouble_;

  std::atomic<bool> running_{false};
  std::atomic<bool> stop_{false};
  std::atomic<int> resets_{0};
  std::atomic<int> processId_{0};
  std::promise<Result<void>> opened_;

  // This session's thread alone, from here on.
  QemuProcess process_;
  std::optional<QemuLink> link_;
  std::mutex linkMutex_;  ///< only guards that link_ exists, for wake()
  std::array<std::string, kPorts> portPaths_;
  std::array<unsigned, kPorts> levels_{};  ///< outputs, as traced
  MotorOutputs motors_;
  Signals signals_;
  std::array<std::int64_t, 2> shown_{};  ///< encoder counts that the pins stand for
  bool counting_ = false;                ///< the firmware's encoder interrupts are on
  bool wasReset_ = false;
  bool shownReady_ = true;
  std::array<double, 3> shownField_{};
  Seconds nextField_{};
  std::array<EchoSource, firmware::kRangers> echoes_;
  Seconds pinDelay_{30e-6};  ///< from an order to the emulator to the pin, as seen lately
  std::string lastRemark_;

  std::thread thread_;
};

}  // namespace tessera::sim
