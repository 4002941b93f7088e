#include "plugins/planner/search_graph.hpp"

#include <algorithm>

namespace stope::planner {

SearchGraph::SearchGraph(std::uint32_t nodes, std::span<const ArcBetween> arcs)
    : first_out_(nodes + 1, 0),
      first_in_(nodes + 1, 0),
      arcs_(arcs.size()),
      sources_(arcs.size()),
      given_(arcs.size()),
      into_(arcs.size()) {
  for (const ArcBetween& arc : arcs) {
    ++first_out_[arc.from + 1];
    ++first_in_[arc.to + 1];
  }
  for (std::uint32_t node = 0; node < nodes; ++node) {
    first_out_[node + 1] += first_out_[node];
    first_in_[node + 1] += first_in_[node];
  }
  std::vector<std::uint32_t> next(first_out_.begin(), first_out_.end() - 1);
  for (std::uint32_t i = 0; i < arcs.size(); ++i) {
    const std::uint32_t place = next[arcs[i].from]++;
    arcs_[place] = {arcs[i].to, std::max(1U, arcs[i].cost)};
    sources_[place] = arcs[i].from;
    given_[place] = i;
  }
  next.assign(first_in_.begin(), first_in_.end() - 1);
  for (std::uint32_t arc = 0; arc < arcs_.size(); ++arc)
    into_[next[arcs_[arc].to]++] = {sources_[arc], arc};
}

}  // namespace stope::planner
