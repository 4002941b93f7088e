#pragma once

#include "plugins/topology/dividing_lines.hpp"
#include "plugins/topology/extract_roads.hpp"
#include "stope/payloads/grid_frame.hpp"

namespace stope::topology {

/// Which extractor it is, with all its parameters.
struct ExtractionMethod {
  enum class Kind { kWatershed, kWatershedParts, kVoronoi, kSkeleton };
  Kind kind = Kind::kVoronoi;
  ExtractionParams params;
  BranchParams branches;
  SkeletonParams skeleton;
  PartParams parts;
  bool operator==(const ExtractionMethod&) const = default;

  /// Whether lines may end, so that they are connected and pruned.
  bool branching() const { return kind != Kind::kWatershed; }
  /// Whether its rule looks at the places and sides of edges, not only at their numbers.
  bool measures_outlines() const {
    return kind == Kind::kSkeleton || kind == Kind::kWatershedParts;
  }
  OccupancyRule occupancy() const {
    return {params.occupied_threshold, params.unknown_is_obstacle};
  }
  /// Cells that an obstacle must enclose to count.
  double least_obstacle(const GridFrame& frame) const {
    return params.min_obstacle_area / (frame.resolution * frame.resolution);
  }
  /// Outlines::gap.
  std::int32_t gap(const GridFrame& frame) const;
};

/// The rule of a method for outlines, and what it is made of.
class DividingRule {
 public:
  /// `sides` of the edges by number; measured from the outlines if not given.
  DividingRule(const ExtractionMethod& method, const GridFrame& frame, const Outlines& outlines,
               const std::vector<std::uint8_t>* sides = nullptr);
  DividingRule(const DividingRule&) = delete;
  DividingRule& operator=(const DividingRule&) = delete;
  const SideRule& rule() const { return rule_; }

 private:
  OutlineWays ways_;
  OutlineTurns turns_;
  SideRule rule_;
};

/// How far a change of an outline can be felt by a method's rule.
struct RuleReach {
  std::int32_t edges = 0;      ///< along the outline, from where it changed
  bool by_regrouping = false;  ///< anywhere if edges of one outline come to belong to two, or back
  bool everywhere = false;
};
RuleReach reach_of(const ExtractionMethod& method, const GridFrame& frame);

/// A grid's roads by any method.
RoadGraph extract_roads(const OccupancyGrid& grid, const ExtractionMethod& method,
                        const Checkpoint& checkpoint = never_stop);

}  // namespace stope::topology
