#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "plugins/planner/route_query.hpp"

namespace stope::planner {

/// What it costs to drive between every node and a few landmarks, both ways: the triangle
/// inequality makes a lower bound of it for the cost between any two nodes, which stays one when
/// costs rise (Goldberg and Harrelson 2005). 8 bytes a node and landmark.
class Landmarks {
 public:
  struct Costs {
    std::uint32_t from, to;  ///< landmark to node, node to landmark; kNoArc: no way, or too long
  };

  /// What every node costs to reach from one, or (`against`) to come from to it.
  using CostsOf = std::function<std::vector<WayCost>(std::uint32_t node, bool against)>;

  /// Takes landmarks one after the other, each the node farthest from those before it. Two full
  /// searches a landmark. Calls `pause` between them, which may throw to give up.
  Landmarks(
      const SearchGraph& graph, std::uint32_t count, const std::function<void()>& pause = [] {});
  /// Likewise, of nodes numbered as `costs_of` has them.
  Landmarks(std::uint32_t nodes, std::uint32_t count, const CostsOf& costs_of,
            const std::function<void()>& pause);

  std::uint32_t count() const { return count_; }
  std::span<const Costs> of(std::uint32_t node) const {
    return std::span(costs_).subspan(static_cast<std::size_t>(node) * count_, count_);
  }

 private:
  std::uint32_t count_;
  std::vector<Costs> costs_;  // node by node
};

/// Lower bounds of the cost between any node and the ends of a query, by the landmarks that say
/// most about that query.
class LandmarkBound {
 public:
  /// With `onward` bounds the cost from a node to the nearest of `ends`, else to a node from the
  /// nearest of them. `others` are the ends at the query's other side, where landmarks are tried.
  LandmarkBound(const Landmarks& landmarks, bool onward, std::span<const WayEnd> ends,
                std::span<const WayEnd> others);
  std::int64_t operator()(std::uint32_t node) const {
    std::int64_t best = 0;
    for (std::size_t i = 0; i < chosen_count_; ++i) best = std::max(best, bound(chosen_[i], node));
    return best;
  }

 private:
  struct Chosen {
    std::uint32_t landmark = 0;
    std::int64_t nearest = -1;  // end, as seen along the way from or to the landmark; -1: none
    std::int64_t farthest = 0;  // end, seen the other way
    bool has_farthest = false;  // all ends have such a way
  };
  Chosen measure(std::uint32_t landmark, std::span<const WayEnd> ends) const;
  std::int64_t bound(const Chosen& chosen, std::uint32_t node) const;

  const Landmarks& landmarks_;
  bool onward_;
  std::array<Chosen, 4> chosen_;
  std::size_t chosen_count_ = 0;
};

}  // namespace stope::planner
