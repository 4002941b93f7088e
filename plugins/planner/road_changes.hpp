#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

namespace stope::planner {

/// What is different on the roads for one query: some cost more, some are closed, some are cut at a
/// place. Roads that are not listed are as the network says.
class RoadChanges {
 public:
  static constexpr double kClosed = std::numeric_limits<double>::infinity();
  struct Change {
    double factor = 1;         ///< times the network's cost, at least 1; kClosed: not to be driven
    std::vector<double> cuts;  ///< metres along the road that cannot be passed
    bool passable() const { return factor != kClosed && cuts.empty(); }
  };

  /// Told twice, the dearer counts.
  void raise(std::uint32_t edge, double factor) {
    Change& change = changes_[edge];
    change.factor = std::max(change.factor, factor);
  }
  void close(std::uint32_t edge) { raise(edge, kClosed); }
  /// The road cannot be passed at a place, but driven up to it from either side.
  void cut(std::uint32_t edge, double along) { changes_[edge].cuts.push_back(along); }

  double factor(std::uint32_t edge) const {
    const auto found = changes_.find(edge);
    return found == changes_.end() ? 1.0 : found->second.factor;
  }
  bool closed(std::uint32_t edge) const { return factor(edge) == kClosed; }
  /// Whether a piece of a road cannot be driven.
  bool blocked(std::uint32_t edge, double from, double to) const {
    const auto found = changes_.find(edge);
    if (found == changes_.end()) return false;
    const auto& [factor, cuts] = found->second;
    return factor == kClosed || std::any_of(cuts.begin(), cuts.end(), [&](double cut) {
             return std::min(from, to) <= cut && cut <= std::max(from, to);
           });
  }
  bool empty() const { return changes_.empty(); }
  /// By edge.
  const std::map<std::uint32_t, Change>& all() const { return changes_; }

 private:
  std::map<std::uint32_t, Change> changes_;
};

}  // namespace stope::planner
