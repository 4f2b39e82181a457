// Talks with a running emulator over its wires: bytes for the UARTs, questions and orders for QMP and qtest, the log's
// lines. Whatever waits here goes on emptying every wire, as the emulated processor stands still while one is full.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/units.h"
#include "sim/qemu/qemu_process.h"
#include "sim/qemu/trace_reader.h"

namespace tessera::sim {

/// Used by one thread, but for wake().
class QemuLink {
public:
  /// onTrace is called for every line of the log, from within pump() and everything that waits; it must not call back.
  QemuLink(QemuWires wires, std::function<void(const TraceEvent&)> onTrace);

  /// Waits until something has come, wake() was called, or the time is over. False when the emulator has gone.
  [[nodiscard]] bool pump(Seconds atMost);
  /// Ends a pump() that waits. From any thread.
  void wake() const;

  void sendRadio(std::span<const std::uint8_t> bytes) { append(radio_, bytes); }
  void sendReaders(std::span<const std::uint8_t> bytes) { append(readers_, bytes); }
  [[nodiscard]] std::vector<std::uint8_t> takeRadio() { return std::exchange(radio_.in, {}); }
  [[nodiscard]] std::vector<std::uint8_t> takeReaders() { return std::exchange(readers_.in, {}); }

  /// Executes a QMP command and waits for its answer, at most 5 s.
  [[nodiscard]] Result<nlohmann::json> control(const std::string& command, const nlohmann::json& arguments);
  /// Sends a QMP command without waiting; its answer counts down controlUnderWay().
  void controlLater(const std::string& command, const nlohmann::json& arguments);
  [[nodiscard]] int controlUnderWay() const { return later_; }

  /// Executes qtest commands, sent together, and waits for one answer each ("OK", "OK 0x…"), at most 5 s.
  [[nodiscard]] Result<std::vector<std::string>> pins(const std::vector<std::string>& commands);

private:
  struct Serial {
    Descriptor fd;
    std::vector<std::uint8_t> out;
    std::vector<std::uint8_t> in;
  };
  static void append(Serial& port, std::span<const std::uint8_t> bytes);
  static void flush(Serial& port);
  void sendAll(const Descriptor& fd, const std::string& text);
  void onControlLine(std::string_view line);
  [[nodiscard]] Result<void> waitFor(const std::function<bool()>& come, const std::string& what);

  Serial radio_;
  Serial readers_;
  Descriptor control_;
  Descriptor pins_;
  Descriptor log_;
  Descriptor wake_;
  LineCutter controlLines_;
  LineCutter pinLines_;
  LineCutter logLines_;
  std::deque<std::string> controlAnswers_;
  std::deque<std::string> pinAnswers_;
  std::function<void(const TraceEvent&)> onTrace_;
  bool greeted_ = false;
  int nextId_ = 0;
  int later_ = 0;
};

}  // namespace tessera::sim
