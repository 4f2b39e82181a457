// tessera-world as others start it: a child process with pipes, a port, signals.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "floor/site_json.h"
#include "wire/messages.h"

namespace tessera::world {
namespace {

const std::string kSite = std::string{TESSERA_SOURCE_DIR} + "/resources/sites/paper.tessera.json";

/// The program under test with its three standard streams (errors go with the answers).
class Child {
public:
  explicit Child(std::vector<std::string> words) {
    int in[2];
    int out[2];
    if (::pipe2(in, O_CLOEXEC) != 0 || ::pipe2(out, O_CLOEXEC) != 0) return;
    words.insert(words.begin(), TESSERA_WORLD);
    id_ = ::fork();
    if (id_ == 0) {
      ::dup2(in[0], 0);
      ::dup2(out[1], 1);
      ::dup2(out[1], 2);
      std::vector<char*> argv;
      for (auto& w : words) argv.push_back(w.data());
      argv.push_back(nullptr);
      ::execv(TESSERA_WORLD, argv.data());
      ::_exit(127);
    }
    ::close(in[0]);
    ::close(out[1]);
    in_ = in[1];
    out_ = out[0];
  }
  ~Child() {
    closeInput();
    if (id_ > 0) {
      ::kill(id_, SIGKILL);
      ::waitpid(id_, nullptr, 0);
    }
    ::close(out_);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// The next line; empty when none comes for twenty seconds or the program has ended.
  std::string line() {
    while (text_.find('\n') == std::string::npos) {
      pollfd p{out_, POLLIN, 0};
      std::array<char, 4096> piece{};
      if (::poll(&p, 1, 20'000) <= 0) return {};
      const ssize_t n = ::read(out_, piece.data(), piece.size());
      if (n <= 0) return std::exchange(text_, {});
      text_.append(piece.data(), static_cast<std::size_t>(n));
    }
    const auto end = text_.find('\n');
    const std::string first = text_.substr(0, end);
    text_.erase(0, end + 1);
    return first;
  }
  std::string ask(const std::string& command) {
    const std::string words = command + "\n";
    EXPECT_EQ(::write(in_, words.data(), words.size()), static_cast<ssize_t>(words.size()));
    return line();
  }
  void closeInput() {
    if (in_ >= 0) ::close(in_);
    in_ = -1;
  }
  void signal(int which) const { ::kill(id_, which); }
  /// The exit code; waits. What it still says is thrown away.
  int wait() {
    std::array<char, 4096> piece{};
    while (::read(out_, piece.data(), piece.size()) > 0) {
    }
    int status = 0;
    ::waitpid(id_, &status, 0);
    id_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

private:
  pid_t id_ = -1;
  int in_ = -1;
  int out_ = -1;
  std::string text_;
};

std::string portOf(Child& child) {
  const auto ready = nlohmann::json::parse(child.line(), nullptr, false);
  return ready.is_object() ? ready.value("port", std::string{}) : std::string{};
}

/// Says Hello through the port until the vehicle answers, for at most twenty seconds.
bool answers(const std::string& port) {
  const auto site = floor::loadSite(kSite);
  const auto& vehicle = site->vehicles.front();
  const int fd = ::open(port.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK);
  wire::FrameDecoder decoder;
  bool found = false;
  for (int i = 0; i < 40 && fd >= 0 && !found; ++i) {
    std::array<std::uint8_t, 16> body{};
    const std::size_t size = wire::encode(wire::Hello{5, 0}, body);
    std::array<std::uint8_t, wire::kMaxFrame> frame{};
    const wire::FrameHeader header{vehicle.id.value, 0, static_cast<std::uint8_t>(wire::MessageType::Hello), 0};
    const std::size_t n = wire::sealFrame(vehicle.key, 0, header, wire::Bytes{body}.first(size), frame);
    EXPECT_EQ(::write(fd, frame.data(), n), static_cast<ssize_t>(n));
    pollfd p{fd, POLLIN, 0};
    while (!found && ::poll(&p, 1, 500) > 0) {
      std::array<std::uint8_t, 256> bytes{};
      const ssize_t got = ::read(fd, bytes.data(), bytes.size());
      if (got <= 0) break;
      decoder.feed(wire::Bytes{bytes}.first(static_cast<std::size_t>(got)), [&](const wire::Frame& f) {
        found = found || f.header.type == static_cast<std::uint8_t>(wire::MessageType::Identity);
      });
    }
  }
  ::close(fd);
  return found;
}

TEST(WorldProcess, offersAPortBehindWhichAVehicleAnswers) {
  Child child{{kSite}};
  const std::string port = portOf(child);
  ASSERT_FALSE(port.empty());
  EXPECT_TRUE(answers(port));
  EXPECT_EQ(child.ask("quit"), "ending");
  EXPECT_EQ(child.wait(), 0);
}

TEST(WorldProcess, obeysAndAnswersInJson) {
  Child child{{kSite, "--json"}};
  ASSERT_FALSE(portOf(child).empty());
  const auto done = nlohmann::json::parse(child.ask("kill 1"), nullptr, false);
  EXPECT_TRUE(done.is_object() && done.contains("done"));
  const auto refused = nlohmann::json::parse(child.ask("kill 9"), nullptr, false);
  EXPECT_TRUE(refused.is_object() && refused.contains("error"));
}

TEST(WorldProcess, bringsItsPortBackUnderTheSameLink) {
  const auto link = std::filesystem::temp_directory_path() / ("tessera-link-" + std::to_string(::getpid()));
  Child child{{kSite, "--link", link.string()}};
  ASSERT_EQ(portOf(child), link.string());
  EXPECT_EQ(child.ask("pull"), "the port is closed");
  EXPECT_FALSE(std::filesystem::exists(std::filesystem::symlink_status(link)));
  EXPECT_EQ(child.ask("plug"), "the port is " + link.string());
  EXPECT_TRUE(answers(link.string()));
  child.signal(SIGTERM);
  EXPECT_EQ(child.wait(), 0);
  EXPECT_FALSE(std::filesystem::exists(std::filesystem::symlink_status(link)));
}

TEST(WorldProcess, endsWithItsParentOnlyWhenTold) {
  Child told{{kSite, "--with-parent"}};
  ASSERT_FALSE(portOf(told).empty());
  told.closeInput();
  EXPECT_EQ(told.wait(), 0);
  Child untold{{kSite}};
  const std::string port = portOf(untold);
  untold.closeInput();
  EXPECT_TRUE(answers(port));
  untold.signal(SIGINT);
  EXPECT_EQ(untold.wait(), 0);
}

TEST(WorldProcess, endsByItselfAndLeavesTheTrueWay) {
  const auto truth = std::filesystem::temp_directory_path() / ("tessera-way-" + std::to_string(::getpid()) + ".csv");
  Child child{{kSite, "--duration", "0.5", "--truth", truth.string()}};
  EXPECT_EQ(child.wait(), 0);
  std::ifstream file{truth};
  std::string line;
  int lines = 0;
  while (std::getline(file, line)) ++lines;
  EXPECT_GT(lines, 10);
  std::filesystem::remove(truth);
}

TEST(WorldProcess, tellsWrongCallsAndBadInputByExitCodeAndSentence) {
  Child unknown{{kSite, "--no-such-option"}};
  EXPECT_EQ(unknown.wait(), 2);
  Child nobody{{kSite, "--vehicle", "99"}};
  EXPECT_THAT(nobody.line(), testing::HasSubstr("99"));
  EXPECT_EQ(nobody.wait(), 3);
  const std::string noSite = std::string{TESSERA_SOURCE_DIR} + "/resources/sites/README.md";
  Child wrongFile{{noSite}};
  EXPECT_THAT(wrongFile.line(), testing::HasSubstr(noSite));
  EXPECT_EQ(wrongFile.wait(), 3);
  Child missingSite{{"/nonexistent.tessera.json"}};
  EXPECT_THAT(missingSite.line(), testing::HasSubstr("/nonexistent.tessera.json"));
  EXPECT_EQ(missingSite.wait(), 3);
  Child missingFirmware{{kSite, "--kind", "qemu", "--firmware", "/nonexistent.elf"}};
  EXPECT_THAT(missingFirmware.line(), testing::HasSubstr("/nonexistent.elf"));
  EXPECT_EQ(missingFirmware.wait(), 3);
}

}  // namespace
}  // namespace tessera::world
