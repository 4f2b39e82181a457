#include "sim/qemu/qemu_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace tessera::sim {
namespace {

constexpr std::uintmax_t kEepromSize = 4096;

struct Pair {
  Descriptor ours;
  Descriptor theirs;
};

Result<Pair> socketPair() {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    return failure(std::string{"No socket for the emulator: "} + std::strerror(errno) + ".");
  ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
  return Pair{Descriptor{ends[0]}, Descriptor{ends[1]}};
}

Result<Pair> pipePair() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    return failure(std::string{"No pipe for the emulator: "} + std::strerror(errno) + ".");
  ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
  return Pair{Descriptor{ends[0]}, Descriptor{ends[1]}};
}

std::string chardev(const char* id, const Pair& pair) {
  return std::string{"socket,id="} + id + ",fd=" + std::to_string(pair.theirs.get());
}

/// Commas separate options in QEMU's arguments; inside a value they are written twice.
std::string escaped(const std::string& value) {
  std::string out;
  for (char c : value) out.append(c == ',' ? 2 : 1, c);
  return out;
}

std::vector<std::string> arguments(const std::string& emulator, const std::string& program, const std::string& eeprom,
                                   const std::array<Pair, 4>& pairs) {
  return {emulator,
          "-M",
          "lm3s6965evb",
          "-nodefaults",
          "-display",
          "none",
          "-S",
          "-kernel",
          program,
          "-chardev",
          chardev("radio", pairs[0]),
          "-serial",
          "chardev:radio",
          "-chardev",
          chardev("readers", pairs[1]),
          "-serial",
          "chardev:readers",
          "-chardev",
          chardev("control", pairs[2]),
          "-mon",
          "chardev=control,mode=control",
          "-chardev",
          chardev("pins", pairs[3]),
          "-object",
          "qtest,id=pinsdriver,chardev=pins,log=/dev/null",
          "-device",
          "lsm303dlhc_mag,id=compass,bus=i2c,address=0x1e",
          "-drive",
          "if=none,id=eeprom,format=raw,file=" + escaped(eeprom),
          "-device",
          "at24c-eeprom,bus=i2c,address=0x50,rom-size=" + std::to_string(kEepromSize) + ",drive=eeprom",
          "-d",
          "unimp",
          "-trace",
          "pl061_set_output",
          "-trace",
          "pl061_reset"};
}

/// Between fork and exec only calls that are safe in a process with other threads.
[[noreturn]] void becomeEmulator(char* const* argv, const std::array<Pair, 4>& pairs, int log, int failed,
                                 pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
  for (const Pair& pair : pairs) ::fcntl(pair.theirs.get(), F_SETFD, 0);
  ::dup2(log, STDERR_FILENO);
  const int nothing = ::open("/dev/null", O_RDWR);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(nothing, STDOUT_FILENO);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::execvp(argv[0], argv);
  const int why = errno;
  static_cast<void>(!::write(failed, &why, sizeof why));
  ::_exit(127);
}

}  // namespace

Descriptor& Descriptor::operator=(Descriptor&& o) noexcept {
  if (this != &o) {
    close();
    fd_ = std::exchange(o.fd_, -1);
  }
  return *this;
}

void Descriptor::close() {
  if (fd_ >= 0) ::close(std::exchange(fd_, -1));
}

Result<QemuWires> QemuProcess::start(const std::string& emulator, const std::string& program,
                                     const std::string& eeprom) {
  std::array<Pair, 4> pairs;
  for (Pair& pair : pairs) {
    auto made = socketPair();
    if (!made) return tl::unexpected{made.error()};
    pair = std::move(*made);
  }
  auto log = pipePair();
  if (!log) return tl::unexpected{log.error()};
  auto failed = pipePair();
  if (!failed) return tl::unexpected{failed.error()};

  std::vector<std::string> words = arguments(emulator, program, eeprom, pairs);
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  const pid_t parent = ::getpid();
  id_ = ::fork();
  if (id_ == 0) becomeEmulator(argv.data(), pairs, log->theirs.get(), failed->theirs.get(), parent);
  if (id_ < 0) {
    id_ = 0;
    return failure(std::string{"The emulator could not be started: "} + std::strerror(errno) + ".");
  }
  failed->theirs.close();
  ::fcntl(failed->ours.get(), F_SETFL, 0);
  int why = 0;
  ssize_t got = 0;
  do got = ::read(failed->ours.get(), &why, sizeof why);  // ends when exec closes the pipe
  while (got < 0 && errno == EINTR);
  if (got > 0) {
    end();
    if (why == ENOENT)
      return failure("The emulator '" + emulator + "' is not installed; on Debian: apt install qemu-system-arm.");
    return failure("The emulator '" + emulator + "' could not be started: " + std::strerror(why) + ".");
  }
  return QemuWires{std::move(pairs[0].ours), std::move(pairs[1].ours), std::move(pairs[2].ours),
                   std::move(pairs[3].ours), std::move(log->ours)};
}

void QemuProcess::end() {
  if (id_ <= 0) return;
  ::kill(id_, SIGKILL);
  while (::waitpid(id_, nullptr, 0) < 0 && errno == EINTR) {
  }
  id_ = 0;
}

Result<void> prepareEeprom(const std::string& path) {
  std::error_code none;
  const auto size = std::filesystem::file_size(path, none);
  if (!none) {
    if (size == kEepromSize) return {};
    return failure("The EEPROM file '" + path + "' has " + std::to_string(size) + " bytes instead of " +
                   std::to_string(kEepromSize) + ".");
  }
  std::ofstream file{path, std::ios::binary};
  const std::string erased(kEepromSize, '\xFF');
  if (!file.write(erased.data(), static_cast<std::streamsize>(erased.size())).flush())
    return failure("The EEPROM file '" + path + "' cannot be written.");
  return {};
}

}  // namespace tessera::sim
