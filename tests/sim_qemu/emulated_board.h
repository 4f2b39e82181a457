// An emulated board with the exerciser program, and waiting for what it does.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "sim/qemu/qemu_host.h"

namespace tessera::sim {

/// Waits for `condition`, asking every millisecond, at most `limit`; tells whether it came.
template <class Condition>
[[nodiscard]] bool eventually(Condition&& condition, Seconds limit = Seconds{10.0}) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(limit.value());
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds{1});
  }
  return true;
}

class EmulatedBoard : public ::testing::Test {
protected:
  explicit EmulatedBoard(const char* program = EXERCISER_ELF)
      : directory_{std::filesystem::temp_directory_path() /
                   ("tessera-qemu-" + std::to_string(::getpid()) + "-" +
                    ::testing::UnitTest::GetInstance()->current_test_info()->name())},
        program_{program},
        host_{makeConfig()} {}
  ~EmulatedBoard() override {
    host_.kill();
    std::filesystem::remove_all(directory_);
  }

  void start() {
    const auto started = host_.start(Seconds{});
    ASSERT_TRUE(started) << started.error().sentence;
    waitUntilItListens();
  }
  /// Bytes that come before the firmware has set its port up are lost, so greetings are repeated until one is heard.
  void waitUntilItListens() {
    int sent = 0;
    ASSERT_TRUE(eventually([&] {
      if (sent++ % 50 == 0) say("hello");
      collect();
      return heard_.find("hello\n") != std::string::npos;
    })) << host_.trouble();
    // Answers to further greetings may still be under way; they end before that to this one.
    say("micros");
    ASSERT_TRUE(eventually([&] {
      collect();
      return !heard_.empty() && heard_.back() == '\n' && heard_.find_last_of("0123456789") == heard_.size() - 2;
    }));
    heard_.clear();
  }
  void say(const std::string& line) {
    const std::string text = line + "\n";
    host_.fromRadio(std::span{reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  }
  /// The line that answers `line`.
  std::string ask(const std::string& line) {
    heard_.clear();
    say(line);
    EXPECT_TRUE(eventually([&] {
      collect();
      return heard_.find('\n') != std::string::npos;
    })) << "no answer to '"
        << line << "' " << host_.trouble();
    return heard_.substr(0, heard_.find('\n'));
  }
  std::vector<long> askNumbers(const std::string& line) {
    std::istringstream in{ask(line)};
    std::vector<long> numbers;
    for (long n = 0; in >> n;) numbers.push_back(n);
    return numbers;
  }
  void collect() {
    const Actions actions = host_.take();
    heard_.append(actions.toRadio.begin(), actions.toRadio.end());
    onReaders_.insert(onReaders_.end(), actions.toReaders.begin(), actions.toReaders.end());
    duty_ = actions.duty;
    mode_ = actions.radioMode;
  }
  QemuConfig makeConfig() const {
    std::filesystem::create_directories(directory_);
    QemuConfig config;
    config.program = program_;
    config.eeprom = directory_ / "eeprom.bin";
    return config;
  }

  std::filesystem::path directory_;
  std::string program_;
  QemuHost host_;
  std::string heard_;
  std::vector<std::uint8_t> onReaders_;
  std::array<int, 2> duty_{};
  firmware::RadioMode mode_{};
};

}  // namespace tessera::sim
