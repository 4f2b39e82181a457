#include "sim/pty/pty.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string>

namespace tessera::sim {
namespace {

namespace fs = std::filesystem;

/// The program at the other end.
class Client {
public:
  explicit Client(const std::string& path) : fd_{::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK)} {}
  ~Client() { ::close(fd_); }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;
  [[nodiscard]] int fd() const { return fd_; }
  void write(const std::string& text) const {
    ASSERT_EQ(::write(fd_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  /// Waits for at most two seconds.
  [[nodiscard]] std::string read(std::size_t count) const {
    std::string got;
    while (got.size() < count) {
      pollfd p{fd_, POLLIN, 0};
      if (::poll(&p, 1, 2000) <= 0) break;
      std::array<char, 4096> piece{};
      const ssize_t n = ::read(fd_, piece.data(), piece.size());
      if (n <= 0) break;
      got.append(piece.data(), static_cast<std::size_t>(n));
    }
    return got;
  }

private:
  int fd_;
};

std::string readAll(Pty& pty) {
  pollfd p{pty.fd(), POLLIN, 0};
  ::poll(&p, 1, 2000);
  const auto bytes = pty.read();
  return {bytes.begin(), bytes.end()};
}

void write(Pty& pty, const std::string& text) {
  pty.write(std::span{reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

TEST(Pty, carriesEveryByteValueUnchangedInBothDirections) {
  auto pty = Pty::open();
  ASSERT_TRUE(pty) << pty.error().sentence;
  const Client client{pty->path()};
  std::string all;
  for (int i = 0; i < 256; ++i) all.push_back(static_cast<char>(i));
  client.write(all);
  EXPECT_EQ(readAll(*pty), all);
  write(*pty, all);
  EXPECT_EQ(client.read(all.size()), all);
}

TEST(Pty, survivesThatTheOtherEndClosesAndOpensAgain) {
  auto pty = Pty::open();
  ASSERT_TRUE(pty);
  EXPECT_FALSE(pty->connected());
  for (int round = 0; round < 3; ++round) {
    const Client client{pty->path()};
    EXPECT_TRUE(pty->connected());
    client.write("there");
    EXPECT_EQ(readAll(*pty), "there");
    write(*pty, "back");
    EXPECT_EQ(client.read(4), "back");
  }
  EXPECT_FALSE(pty->connected());
}

TEST(Pty, losesBytesForAPortThatNobodyHoldsOpen) {
  auto pty = Pty::open();
  ASSERT_TRUE(pty);
  write(*pty, "old");
  EXPECT_EQ(pty->dropped(), 3U);
  const Client client{pty->path()};
  write(*pty, "new");
  EXPECT_EQ(client.read(3), "new");
}

TEST(Pty, keepsABoundedBacklogForAReaderThatSleeps) {
  auto pty = Pty::open();
  ASSERT_TRUE(pty);
  const Client client{pty->path()};
  for (int i = 0; i < 1000; ++i) write(*pty, std::string(1000, 'x'));
  EXPECT_TRUE(pty->waiting());
  EXPECT_GT(pty->dropped(), 500'000U);
  EXPECT_FALSE(client.read(1).empty());
}

TEST(Pty, showsTheOtherEndThatItIsGone) {
  auto pty = Pty::open();
  ASSERT_TRUE(pty);
  const Client client{pty->path()};
  { const Pty gone = std::move(*pty); }
  pollfd p{client.fd(), POLLIN, 0};
  ASSERT_EQ(::poll(&p, 1, 2000), 1);
  EXPECT_TRUE((p.revents & POLLHUP) != 0);
}

TEST(Pty, makesALinkReplacesAnOldOneAndTakesItAway) {
  const fs::path folder = fs::temp_directory_path() / ("tessera-pty-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  const fs::path link = folder / "port";
  fs::create_symlink("/dev/null", link);
  {
    auto pty = Pty::open(link.string());
    ASSERT_TRUE(pty) << pty.error().sentence;
    EXPECT_EQ(fs::read_symlink(link).string(), pty->device());
    const Client client{pty->path()};
    client.write("x");
    EXPECT_EQ(readAll(*pty), "x");
  }
  EXPECT_FALSE(fs::is_symlink(link));
  std::ofstream{link} << "precious";
  const auto refused = Pty::open(link.string());
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence.english().find(link.string()), std::string::npos);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace tessera::sim
