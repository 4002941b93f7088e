#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "plugins/planner/contraction_hierarchy.hpp"
#include "plugins/planner/landmarks.hpp"

namespace stope::planner {

/// Landmarks for a hierarchy's nodes by rank; none if it has no chains, as climbs are short then.
/// Some 2 s and 128 MB for a million nodes. Calls `pause` now and then, which may throw to give up.
std::optional<Landmarks> landmarks_by_rank(
    const ContractionHierarchy& hierarchy, const std::function<void()>& pause = [] {});

/// The nodes of a hierarchy, by rank, over which a way from a query's sources to its targets may
/// cost no more than so much, for all that landmarks can tell. See the .cpp. Keeps references to
/// the hierarchy and the landmarks.
class Corridor {
 public:
  Corridor(const ContractionHierarchy& hierarchy, const Landmarks& landmarks,
           std::span<const WayEnd> sources, std::span<const WayEnd> targets);

  /// Ways that cost more than `most` may be missed from now on; kNoWay: none.
  void narrow(WayCost most) { most_ = most; }
  WayCost most() const { return most_; }
  /// Whether the arcs of a node are to be looked at. There are few, or it lies in the corridor.
  bool is_worth(std::uint32_t rank, const ContractionHierarchy::Half& half) const {
    return half.first[rank + 1] - half.first[rank] < kFew || most_ == kNoWay ||
           static_cast<WayCost>(ahead_(rank) + behind_(rank)) <= most_;
  }
  /// Calls `found()` for wider and wider corridors until it says that it has found a way that costs
  /// no more than most().
  template <class Found>
  void widen_until(const Found& found) {
    for (const WayCost share : {64, 8}) {
      if (least_ >= kNoWay / 2) break;
      narrow(least_ + least_ / share);
      if (found()) return;
    }
    narrow(kNoWay);
    found();
  }

 private:
  static constexpr std::uint32_t kFew = 12;  // arcs that are sooner looked at than reasoned about

  LandmarkBound ahead_, behind_;
  WayCost least_ = kNoWay, most_ = kNoWay;
};

}  // namespace stope::planner
