#include "plugins/topology/extraction_method.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stope::topology {
namespace {

using Kind = ExtractionMethod::Kind;

// Below these, in cells, a rule would follow the raster's steps.
constexpr double kLeastResidual = 2.0;
constexpr double kLeastLambda = 4.0;

bool by_lambda(const ExtractionMethod& method) {
  return method.skeleton.pruning == SkeletonParams::Pruning::kLambda;
}

double skeleton_cells(const ExtractionMethod& method, const GridFrame& frame) {
  return by_lambda(method) ? std::max(method.skeleton.lambda / frame.resolution, kLeastLambda)
                           : std::max(method.skeleton.residual / frame.resolution, kLeastResidual);
}

SideRule rule_of(const ExtractionMethod& method, const GridFrame& frame, const Outlines& outlines,
                 const OutlineWays& ways, const OutlineTurns& turns) {
  switch (method.kind) {
    case Kind::kWatershed:
      return SideRule::between_outlines(outlines);
    case Kind::kWatershedParts:
      return SideRule::between_parts(outlines, turns);
    case Kind::kVoronoi:
      return SideRule::between_sides(outlines);
    case Kind::kSkeleton:
      break;
  }
  const double cells = skeleton_cells(method, frame);
  return by_lambda(method) ? SideRule::by_separation(outlines, cells)
                           : SideRule::by_residual(outlines, ways, cells);
}

}  // namespace

std::int32_t ExtractionMethod::gap(const GridFrame& frame) const {
  constexpr std::int32_t kGapBetweenOutlines = 64;
  if (kind == Kind::kWatershed) return kGapBetweenOutlines;
  // Two cells by whose numbers they are n apart are at most 1.42 n cells apart, along and across;
  // both sides of a branch that reaches n cells are at least as long.
  const double cells = kind == Kind::kSkeleton ? skeleton_cells(*this, frame) / std::numbers::sqrt2
                                               : branches.min_branch / frame.resolution;
  return static_cast<std::int32_t>(std::clamp(std::floor(cells), 3.0, 1e6));
}

DividingRule::DividingRule(const ExtractionMethod& method, const GridFrame& frame,
                           const Outlines& outlines, const std::vector<std::uint8_t>* sides)
    : ways_(method.kind == Kind::kSkeleton && !by_lambda(method) ? measure_ways(outlines, sides)
                                                                 : OutlineWays{}),
      turns_(
          method.kind == Kind::kWatershedParts
              ? find_turns(outlines,
                           {method.parts.corner_angle, method.parts.part_length / frame.resolution},
                           sides)
              : OutlineTurns{}),
      rule_(rule_of(method, frame, outlines, ways_, turns_)) {}

RuleReach reach_of(const ExtractionMethod& method, const GridFrame& frame) {
  switch (method.kind) {
    case Kind::kWatershed:
      return {0, true, false};
    case Kind::kVoronoi:
      return {method.gap(frame), false, false};
    case Kind::kSkeleton:
      if (by_lambda(method)) return {method.gap(frame), true, false};
      break;
    case Kind::kWatershedParts:
      break;
  }
  // Ways and turns between two edges, however far apart, are others after a change between them.
  return {0, true, true};
}

}  // namespace stope::topology
