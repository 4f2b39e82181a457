// Edges of a graph as lines to follow. For this folder's sources.
#pragma once

#include <string>
#include <vector>

namespace tessera::exchange {

struct LifEdge {
  std::string id;
  std::string name;
  std::size_t from = 0;  ///< index of the node
  std::size_t to = 0;
};
struct Chain {
  std::string name;
  std::vector<std::size_t> nodes;
  std::vector<std::size_t> edges;  ///< between them, as indices
};

/// Edges ROUTE/1, ROUTE/2, ... that follow one another become ROUTE; of the others those that lead on without a choice
/// become one chain, called after its first edge. Every edge is in just one chain.
[[nodiscard]] std::vector<Chain> chainsOf(const std::vector<LifEdge>& edges, const std::vector<std::string>& nodeIds);

/// The first so many characters of a text in UTF-8.
[[nodiscard]] std::string shortened(std::string text, std::size_t most);

}  // namespace tessera::exchange
