#include "sim/qemu/qemu_link.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <nlohmann/json.hpp>

namespace tessera::sim {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kQueueLimit = 4096;
constexpr auto kAnswerLimit = std::chrono::seconds{5};

/// Everything that stands in `fd`; false when the other side has closed it.
template <class Sink>
bool drain(const Descriptor& fd, Sink&& sink) {
  std::array<char, 4096> buffer;
  for (;;) {
    const ssize_t n = ::read(fd.get(), buffer.data(), buffer.size());
    if (n > 0)
      sink(std::string_view{buffer.data(), static_cast<std::size_t>(n)});
    else if (n < 0 && errno == EINTR)
      continue;
    else
      return n < 0 && (errno == EAGAIN || errno == EWOULDBLOCK);
  }
}

void collect(std::vector<std::uint8_t>& into, std::string_view bytes) {
  into.insert(into.end(), bytes.begin(), bytes.end());
}

}  // namespace

QemuLink::QemuLink(QemuWires wires, std::function<void(const TraceEvent&)> onTrace)
    : radio_{std::move(wires.radio), {}, {}},
      readers_{std::move(wires.readers), {}, {}},
      control_{std::move(wires.control)},
      pins_{std::move(wires.pins)},
      log_{std::move(wires.log)},
      wake_{::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)},
      onTrace_{std::move(onTrace)} {}

void QemuLink::wake() const {
  const std::uint64_t one = 1;
  static_cast<void>(!::write(wake_.get(), &one, sizeof one));
}

void QemuLink::append(Serial& port, std::span<const std::uint8_t> bytes) {
  // A vehicle that takes nothing any more loses what comes, as a full UART does.
  if (port.out.size() + bytes.size() <= kQueueLimit) port.out.insert(port.out.end(), bytes.begin(), bytes.end());
  flush(port);
}

void QemuLink::flush(Serial& port) {
  if (port.out.empty()) return;
  const ssize_t n = ::send(port.fd.get(), port.out.data(), port.out.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  if (n > 0) port.out.erase(port.out.begin(), port.out.begin() + n);
}

bool QemuLink::pump(Seconds atMost) {
  const auto wants = [](const Serial& s) { return static_cast<short>(POLLIN | (s.out.empty() ? 0 : POLLOUT)); };
  std::array<pollfd, 6> fds = {pollfd{radio_.fd.get(), wants(radio_), 0},
                               {readers_.fd.get(), wants(readers_), 0},
                               {control_.get(), POLLIN, 0},
                               {pins_.get(), POLLIN, 0},
                               {log_.get(), POLLIN, 0},
                               {wake_.get(), POLLIN, 0}};
  const double seconds = std::max(0.0, atMost.value());
  const timespec limit{static_cast<time_t>(seconds), static_cast<long>((seconds - std::floor(seconds)) * 1e9)};
  if (::ppoll(fds.data(), fds.size(), &limit, nullptr) <= 0) return true;

  std::uint64_t count = 0;
  if (fds[5].revents != 0) static_cast<void>(!::read(wake_.get(), &count, sizeof count));
  bool alive = true;
  // The log first: it says why, should another wire have ended.
  if (fds[4].revents != 0) {
    alive &= drain(log_, [this](std::string_view bytes) {
      logLines_.feed(bytes, [this](std::string_view line) { onTrace_(parseTraceLine(line)); });
    });
  }
  if (fds[0].revents != 0) alive &= drain(radio_.fd, [this](std::string_view b) { collect(radio_.in, b); });
  if (fds[1].revents != 0) alive &= drain(readers_.fd, [this](std::string_view b) { collect(readers_.in, b); });
  if (fds[2].revents != 0) {
    alive &= drain(control_, [this](std::string_view bytes) {
      controlLines_.feed(bytes, [this](std::string_view line) { onControlLine(line); });
    });
  }
  if (fds[3].revents != 0) {
    alive &= drain(pins_, [this](std::string_view bytes) {
      pinLines_.feed(bytes, [this](std::string_view line) { pinAnswers_.emplace_back(line); });
    });
  }
  flush(radio_);
  flush(readers_);
  return alive;
}

void QemuLink::onControlLine(std::string_view line) {
  const Json message = Json::parse(line, nullptr, false);
  if (!message.is_object()) return;
  if (message.contains("QMP")) greeted_ = true;
  if (!message.contains("return") && !message.contains("error")) return;  // an event
  if (message.value("id", "") == "later")
    --later_;
  else
    controlAnswers_.emplace_back(line);
}

void QemuLink::sendAll(const Descriptor& fd, const std::string& text) {
  std::string_view rest = text;
  while (!rest.empty()) {
    const ssize_t n = ::send(fd.get(), rest.data(), rest.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (n > 0)
      rest.remove_prefix(static_cast<std::size_t>(n));
    else if (!pump(Seconds{0.001}))
      return;
  }
}

Result<void> QemuLink::waitFor(const std::function<bool()>& come, const std::string& what) {
  const auto until = std::chrono::steady_clock::now() + kAnswerLimit;
  while (!come()) {
    if (!pump(Seconds{0.1}) && !come()) return failure("The emulator ended by itself.");
    if (std::chrono::steady_clock::now() > until) return failure("The emulator does not answer to " + what + ".");
  }
  return {};
}

Result<Json> QemuLink::control(const std::string& command, const Json& arguments) {
  if (auto greeting = waitFor([this] { return greeted_; }, "its greeting"); !greeting)
    return tl::unexpected{greeting.error()};
  Json message{{"execute", command}};
  if (!arguments.empty()) message["arguments"] = arguments;
  sendAll(control_, message.dump() + "\n");
  if (auto answered = waitFor([this] { return !controlAnswers_.empty(); }, "QMP " + command); !answered)
    return tl::unexpected{answered.error()};
  const Json answer = Json::parse(controlAnswers_.front());
  controlAnswers_.pop_front();
  if (answer.contains("error"))
    return failure("The emulator refused QMP " + command + ": " + answer["error"].value("desc", "no reason given") +
                   ".");
  return answer["return"];
}

void QemuLink::controlLater(const std::string& command, const Json& arguments) {
  ++later_;
  sendAll(control_, Json{{"execute", command}, {"arguments", arguments}, {"id", "later"}}.dump() + "\n");
}

Result<std::vector<std::string>> QemuLink::pins(const std::vector<std::string>& commands) {
  std::string text;
  for (const std::string& command : commands) text += command + "\n";
  sendAll(pins_, text);
  const std::size_t expected = commands.size();
  if (auto answered = waitFor([this, expected] { return pinAnswers_.size() >= expected; }, "qtest " + commands.front());
      !answered)
    return tl::unexpected{answered.error()};
  std::vector<std::string> answers{pinAnswers_.begin(), pinAnswers_.end()};
  pinAnswers_.clear();
  for (const std::string& answer : answers) {
    if (!answer.starts_with("OK"))
      return failure("The emulator refused qtest " + commands.front() + ": " + answer + ".");
  }
  return answers;
}

}  // namespace tessera::sim
