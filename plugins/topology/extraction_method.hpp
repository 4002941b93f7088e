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
  /// A skeleton whose lines are cut by the distance of the places seen, not by the outline between.
  bool by_lambda() const {
    return kind == Kind::kSkeleton && skeleton.pruning == SkeletonParams::Pruning::kLambda;
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
  /// Cells that the places seen from a line must be apart; 0 if that does not matter.
  double least_apart(const GridFrame& frame) const;
};

/// The rule of a method for outlines, and what it is made of.
class DividingRule {
 public:
  DividingRule(const ExtractionMethod& method, const GridFrame& frame, const Outlines& outlines);
  /// `sides` of the edges, where outlines.sides does not tell them.
  DividingRule(const ExtractionMethod& method, const GridFrame& frame, const Outlines& outlines,
               const std::vector<std::uint8_t>& sides);
  DividingRule(const DividingRule&) = delete;
  DividingRule& operator=(const DividingRule&) = delete;

  /// Measures outlines that have changed anew.
  void renew(const OutlineChange& change, const std::vector<std::uint8_t>& sides);

  const SideRule& rule() const { return rule_; }
  const OutlineWays& ways() const { return ways_; }     ///< of a skeleton by residual
  const OutlineTurns& turns() const { return turns_; }  ///< of a watershed of parts
  const TurnRule& turn_rule() const { return turn_rule_; }
  double residual() const { return residual_; }  ///< cells

 private:
  const Outlines& outlines_;
  bool by_residual_, by_turns_;
  double residual_;
  TurnRule turn_rule_;
  OutlineWays ways_;
  OutlineTurns turns_;
  SideRule rule_;
};

/// A grid's roads by any method.
RoadGraph extract_roads(const OccupancyGrid& grid, const ExtractionMethod& method,
                        const Checkpoint& checkpoint = never_stop);

}  // namespace stope::topology
