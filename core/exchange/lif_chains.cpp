#include "exchange/lif_chains.h"

#include <charconv>
#include <optional>
#include <set>
#include <string_view>

namespace tessera::exchange {
namespace {

struct Numbered {
  std::string_view route;
  std::size_t number;
};

// "north/12"
std::optional<Numbered> numbered(std::string_view id) {
  const std::size_t slash = id.rfind('/');
  if (slash == std::string_view::npos || slash == 0) return std::nullopt;
  std::size_t number = 0;
  const char* const end = id.data() + id.size();
  const auto read = std::from_chars(id.data() + slash + 1, end, number);
  if (read.ec != std::errc{} || read.ptr != end) return std::nullopt;
  return Numbered{id.substr(0, slash), number};
}

class Chains {
public:
  Chains(const std::vector<LifEdge>& edges, const std::vector<std::string>& nodeIds)
      : edges_{edges}, nodeIds_{nodeIds}, used_(edges.size(), false), out_(nodeIds.size()), in_(nodeIds.size()) {}

  std::vector<Chain> build() {
    byName();
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      if (used_[i]) continue;
      out_[edges_[i].from].push_back(i);
      in_[edges_[i].to].push_back(i);
    }
    // First those that begin somewhere; what is left then are rings.
    for (const bool rings : {false, true})
      for (std::size_t i = 0; i < edges_.size(); ++i)
        if (!used_[i] && (rings || !before(i))) follow(i);
    return std::move(chains_);
  }

private:
  void byName() {
    for (std::size_t i = 0; i < edges_.size();) {
      const auto first = numbered(edges_[i].id);
      if (!first || first->number != 1) {
        ++i;
        continue;
      }
      Chain chain{std::string{first->route}, {edges_[i].from, edges_[i].to}, {i}};
      used_[i] = true;
      for (++i; i < edges_.size(); ++i) {
        const auto next = numbered(edges_[i].id);
        if (!next || next->route != first->route || next->number != chain.nodes.size() ||
            edges_[i].from != chain.nodes.back())
          break;
        chain.nodes.push_back(edges_[i].to);
        chain.edges.push_back(i);
        used_[i] = true;
      }
      add(std::move(chain));
    }
  }

  // The only edge that leads on from the end of this one, other than straight back.
  [[nodiscard]] std::optional<std::size_t> after(std::size_t edge) const {
    std::optional<std::size_t> next;
    for (const std::size_t i : out_[edges_[edge].to]) {
      if (edges_[i].to == edges_[edge].from) continue;
      if (next) return std::nullopt;
      next = i;
    }
    return next;
  }
  [[nodiscard]] std::optional<std::size_t> onlyInto(std::size_t edge) const {
    std::optional<std::size_t> previous;
    for (const std::size_t i : in_[edges_[edge].from]) {
      if (edges_[i].from == edges_[edge].to) continue;
      if (previous) return std::nullopt;
      previous = i;
    }
    return previous;
  }
  [[nodiscard]] std::optional<std::size_t> successor(std::size_t edge) const {
    const auto next = after(edge);
    return next && onlyInto(*next) == edge ? next : std::nullopt;
  }
  [[nodiscard]] std::optional<std::size_t> before(std::size_t edge) const {
    const auto previous = onlyInto(edge);
    return previous && after(*previous) == edge ? previous : std::nullopt;
  }

  void follow(std::size_t first) {
    const LifEdge& edge = edges_[first];
    Chain chain{edge.name.empty() ? nodeIds_[edge.from] + " - " + nodeIds_[edge.to] : edge.name, {edge.from}, {}};
    for (std::optional<std::size_t> at = first; at && !used_[*at]; at = successor(*at)) {
      used_[*at] = true;
      chain.nodes.push_back(edges_[*at].to);
      chain.edges.push_back(*at);
    }
    add(std::move(chain));
  }

  void add(Chain chain) {
    std::string name = shortened(chain.name, 200);
    for (int n = 2; !names_.insert(name).second; ++n)
      name = shortened(chain.name, 190) + " (" + std::to_string(n) + ")";
    chain.name = std::move(name);
    chains_.push_back(std::move(chain));
  }

  const std::vector<LifEdge>& edges_;
  const std::vector<std::string>& nodeIds_;
  std::vector<bool> used_;
  std::vector<std::vector<std::size_t>> out_;
  std::vector<std::vector<std::size_t>> in_;
  std::set<std::string> names_;
  std::vector<Chain> chains_;
};

}  // namespace

std::string shortened(std::string text, std::size_t most) {
  std::size_t characters = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins = (static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U;
    if (begins && ++characters > most) text.resize(i);
  }
  return text;
}

std::vector<Chain> chainsOf(const std::vector<LifEdge>& edges, const std::vector<std::string>& nodeIds) {
  return Chains{edges, nodeIds}.build();
}

}  // namespace tessera::exchange
