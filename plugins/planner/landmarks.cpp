#include "plugins/planner/landmarks.hpp"

#include <limits>

#include "plugins/planner/dijkstra_search.hpp"
#include "stope/error.hpp"

namespace stope::planner {
namespace {

std::uint32_t shortened(WayCost cost) {
  if (cost == kNoWay) return kNoArc;
  if (cost >= kNoArc) throw Error("the road graph has ways too long to prepare for fast search");
  return static_cast<std::uint32_t>(cost);
}

}  // namespace

Landmarks::Landmarks(const SearchGraph& graph, std::uint32_t count,
                     const std::function<void()>& pause)
    : Landmarks(
          graph.node_count(), count,
          [search = DijkstraSearch(graph)](std::uint32_t node, bool against) mutable {
            return search.costs(node, against);
          },
          pause) {}

Landmarks::Landmarks(std::uint32_t nodes, std::uint32_t count, const CostsOf& costs_of,
                     const std::function<void()>& pause)
    : count_(std::min(count, nodes)), costs_(static_cast<std::size_t>(nodes) * count_) {
  if (count_ == 0) return;
  // A node that no landmark so far is joined to is farther than any that one is.
  std::vector<WayCost> nearest = costs_of(0, false);
  for (WayCost& cost : nearest)
    if (cost == kNoWay) cost = 0;  // the first landmark is of node 0's part
  for (std::uint32_t i = 0; i < count_; ++i) {
    pause();
    const auto landmark = static_cast<std::uint32_t>(
        std::max_element(nearest.begin(), nearest.end()) - nearest.begin());
    const std::vector<WayCost> from = costs_of(landmark, false), to = costs_of(landmark, true);
    for (std::uint32_t node = 0; node < nodes; ++node) {
      costs_[static_cast<std::size_t>(node) * count_ + i] = {shortened(from[node]),
                                                             shortened(to[node])};
      const WayCost near = std::min(from[node], to[node]);
      nearest[node] = i == 0 ? near : std::min(nearest[node], near);
    }
  }
}

LandmarkBound::LandmarkBound(const Landmarks& landmarks, bool onward, std::span<const WayEnd> ends,
                             std::span<const WayEnd> others)
    : landmarks_(landmarks), onward_(onward) {
  std::array<std::int64_t, 4> values{};
  for (std::uint32_t landmark = 0; landmark < landmarks.count(); ++landmark) {
    const Chosen candidate = measure(landmark, ends);
    std::int64_t value = std::numeric_limits<std::int64_t>::max();
    for (const WayEnd& other : others) value = std::min(value, bound(candidate, other.node));
    if (value <= 0 || others.empty()) continue;
    // The best four, in falling order.
    std::size_t place = chosen_count_;
    if (place == chosen_.size()) {
      if (values[place - 1] >= value) continue;
      --place;
    } else {
      ++chosen_count_;
    }
    for (; place > 0 && values[place - 1] < value; --place) {
      values[place] = values[place - 1];
      chosen_[place] = chosen_[place - 1];
    }
    values[place] = value;
    chosen_[place] = candidate;
  }
}

LandmarkBound::Chosen LandmarkBound::measure(std::uint32_t landmark,
                                             std::span<const WayEnd> ends) const {
  Chosen chosen{landmark, -1, std::numeric_limits<std::int64_t>::min()};
  bool all = true;
  for (const WayEnd& end : ends) {
    const Landmarks::Costs costs = landmarks_.of(end.node)[landmark];
    const std::uint32_t with = onward_ ? costs.from : costs.to;
    const std::uint32_t against = onward_ ? costs.to : costs.from;
    const auto extra = static_cast<std::int64_t>(end.cost);
    if (with != kNoArc && (chosen.nearest < 0 || with + extra < chosen.nearest))
      chosen.nearest = with + extra;
    all = all && against != kNoArc;
    if (all) chosen.farthest = std::max(chosen.farthest, against - extra);
  }
  chosen.has_farthest = all && !ends.empty();  // where all is closed there is no end
  return chosen;
}

std::int64_t LandmarkBound::bound(const Chosen& chosen, std::uint32_t node) const {
  const Landmarks::Costs costs = landmarks_.of(node)[chosen.landmark];
  const std::uint32_t with = onward_ ? costs.from : costs.to;
  const std::uint32_t against = onward_ ? costs.to : costs.from;
  std::int64_t best = 0;
  // d(v, ends) >= d(L, ends) - d(L, v), and d(v, ends) >= d(v, L) - d(ends, L).
  if (chosen.nearest >= 0 && with != kNoArc) best = std::max(best, chosen.nearest - with);
  if (chosen.has_farthest && against != kNoArc) best = std::max(best, against - chosen.farthest);
  return best;
}

}  // namespace stope::planner
