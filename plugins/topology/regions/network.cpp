#include "plugins/topology/regions/network.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>

#include "plugins/topology/disjoint_sets.hpp"

namespace stope::topology {
namespace {

std::vector<std::size_t> shortest_first(const std::vector<RegionLink>& links) {
  std::vector<std::size_t> order(links.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return links[a].length < links[b].length; });
  return order;
}

/// Ways over the links kept so far.
class KeptLinks {
 public:
  explicit KeptLinks(std::int32_t count)
      : at_(static_cast<std::size_t>(count)), way_(static_cast<std::size_t>(count), -1) {}

  void keep(const RegionLink& link) {
    at_[static_cast<std::size_t>(link.from)].push_back({link.to, link.length});
    at_[static_cast<std::size_t>(link.to)].push_back({link.from, link.length});
  }

  bool reaches(std::int32_t from, std::int32_t to, double most) {
    using Entry = std::pair<double, std::int32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    std::vector<std::int32_t> seen;
    bool found = false;
    open.push({0.0, from});
    while (!open.empty() && !found) {
      const auto [way, place] = open.top();
      open.pop();
      double& known = way_[static_cast<std::size_t>(place)];
      if (known >= 0) continue;
      known = way;
      seen.push_back(place);
      found = place == to;
      for (const auto& [next, length] : at_[static_cast<std::size_t>(place)])
        if (way_[static_cast<std::size_t>(next)] < 0 && way + length <= most)
          open.push({way + length, next});
    }
    for (const std::int32_t place : seen) way_[static_cast<std::size_t>(place)] = -1;
    return found;
  }

 private:
  std::vector<std::vector<std::pair<std::int32_t, double>>> at_;
  std::vector<double> way_;  ///< from the start of the search; -1: not reached
};

}  // namespace

std::vector<std::size_t> spanning_tree(std::int32_t count, const std::vector<RegionLink>& links) {
  DisjointSets parts(static_cast<std::size_t>(count));
  std::vector<std::size_t> kept;
  for (const std::size_t i : shortest_first(links))
    if (parts.join(links[i].from, links[i].to)) kept.push_back(i);
  std::sort(kept.begin(), kept.end());
  return kept;
}

std::vector<std::size_t> spanner(std::int32_t count, const std::vector<RegionLink>& links,
                                 double stretch) {
  KeptLinks network(count);
  std::vector<std::size_t> kept;
  for (const std::size_t i : shortest_first(links)) {
    if (network.reaches(links[i].from, links[i].to, stretch * links[i].length)) continue;
    network.keep(links[i]);
    kept.push_back(i);
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

}  // namespace stope::topology
