// Two pseudo terminals whose far ends are joined: what one program writes to its terminal the other one reads from its.
#pragma once

#include <array>
#include <string>
#include <thread>

namespace tessera::system_test {

class PtyBridge {
public:
  PtyBridge();
  ~PtyBridge();
  PtyBridge(const PtyBridge&) = delete;
  PtyBridge& operator=(const PtyBridge&) = delete;

  /// index 0 or 1: the path of that terminal.
  [[nodiscard]] const std::string& path(std::size_t index) const { return ends_.at(index).path; }

private:
  struct End {
    int master = -1;
    int kept = -1;  ///< our own handle on the terminal, so that it lives before a program has opened it
    std::string path;
  };
  void carry() const;

  std::array<End, 2> ends_;
  std::array<int, 2> stop_{-1, -1};
  std::thread thread_;
};

}  // namespace tessera::system_test
