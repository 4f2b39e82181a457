// The readers at the other end of the bus: answers to the board's polls, at once or never.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "tests/firmware/fake_board.h"

namespace tessera::firmware::test {

class FakeReaderBus {
public:
  struct Node {
    std::uint8_t counter = 0;
    std::vector<std::uint8_t> data;  ///< UID, or the gauge's two bytes
  };
  std::map<std::uint8_t, Node> nodes;
  std::map<std::uint8_t, int> polls;
  int malformed = 0;

  void setMillivolts(int mv) { nodes[15].data = {static_cast<std::uint8_t>(mv), static_cast<std::uint8_t>(mv >> 8)}; }

  void serve(FakeBoard& board) {
    const auto bytes = board.takeOutgoing(Uart::Readers);
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
      const auto complement = static_cast<std::uint8_t>(~bytes[i]);
      if ((bytes[i] & 0xF0) != 0xB0 || bytes[i + 1] != complement) {
        ++malformed;
        continue;
      }
      const auto node = static_cast<std::uint8_t>(bytes[i] & 0x0F);
      ++polls[node];
      if (const auto found = nodes.find(node); found != nodes.end()) answer(board, node, found->second);
    }
  }
  static std::vector<std::uint8_t> answerOf(std::uint8_t node, const Node& n) {
    std::vector<std::uint8_t> out{static_cast<std::uint8_t>(0xD0 | node), static_cast<std::uint8_t>(n.data.size()),
                                  n.counter};
    for (std::uint8_t b : n.data) out.push_back(b);
    std::uint8_t sum = 0;
    for (std::uint8_t b : out) sum ^= b;
    out.push_back(sum);
    return out;
  }

private:
  static void answer(FakeBoard& board, std::uint8_t node, const Node& n) {
    const auto out = answerOf(node, n);
    board.incoming[1].insert(board.incoming[1].end(), out.begin(), out.end());
  }
};

}  // namespace tessera::firmware::test
