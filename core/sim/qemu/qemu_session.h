// One life of an emulated vehicle: the emulator, the thread that serves it, and what hangs on its pins.
#pragma once

#include <atomic>
#include <future>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "sim/qemu/board_pins.h"
#include "sim/qemu/qemu_host.h"
#include "sim/qemu/qemu_link.h"
#include "sim/qemu/qemu_process.h"

namespace tessera::sim {

class QemuHost::Session {
public:
  Session(const QemuConfig& config, const Signals& shown);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Waits until the board runs or has failed to.
  [[nodiscard]] Result<void> ready();
  void set(const Signals& shown);
  void send(firmware::Uart port, std::span<const std::uint8_t> bytes);
  [[nodiscard]] Actions take();
  [[nodiscard]] bool running() const { return running_; }
  [[nodiscard]] std::string trouble() const;
  [[nodiscard]] int resets() const { return resets_; }
  [[nodiscard]] int processId() const { return processId_; }

private:
  void run();
  [[nodiscard]] Result<void> open();
  [[nodiscard]] Result<void> serve();
  void takeOver();
  void publish();
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
  BoardPins pins_;
  Signals signals_;

  std::thread thread_;
};

}  // namespace tessera::sim
