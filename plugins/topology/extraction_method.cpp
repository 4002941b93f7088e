#include "plugins/topology/extraction_method.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>

namespace stope::topology {
namespace {

using Kind = ExtractionMethod::Kind;

// Below these, in cells, a rule would follow the raster's steps.
constexpr double kLeastResidual = 2.0;
constexpr double kLeastLambda = 4.0;

double skeleton_cells(const ExtractionMethod& method, const GridFrame& frame) {
  return method.by_lambda() ? std::max(method.skeleton.lambda / frame.resolution, kLeastLambda)
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
  // Lambda cuts lines between sides afterwards, so that it can tell which it must not cut.
  return method.by_lambda() ? SideRule::between_sides(outlines)
                            : SideRule::by_residual(outlines, ways, skeleton_cells(method, frame));
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

double ExtractionMethod::least_apart(const GridFrame& frame) const {
  return by_lambda() ? skeleton_cells(*this, frame) : 0;
}

DividingRule::DividingRule(const ExtractionMethod& method, const GridFrame& frame,
                           const Outlines& outlines)
    : DividingRule(method, frame, outlines, sides_of_edges(outlines)) {}

DividingRule::DividingRule(const ExtractionMethod& method, const GridFrame& frame,
                           const Outlines& outlines, const std::vector<std::uint8_t>& sides)
    : outlines_(outlines),
      by_residual_(method.kind == Kind::kSkeleton && !method.by_lambda()),
      by_turns_(method.kind == Kind::kWatershedParts),
      residual_(skeleton_cells(method, frame)),
      turn_rule_{method.parts.corner_angle, method.parts.part_length / frame.resolution},
      rule_(rule_of(method, frame, outlines, ways_, turns_)) {
  OutlineChange all;
  all.outlines.resize(outlines.list.size());
  std::iota(all.outlines.begin(), all.outlines.end(), 0);
  renew(all, sides);
}

void DividingRule::renew(const OutlineChange& change, const std::vector<std::uint8_t>& sides) {
  std::span<const StayedRun> runs = change.runs;  // outline by outline, as `outlines` are
  for (const std::int32_t place : change.outlines) {
    std::size_t own = 0;
    while (own < runs.size() && runs[own].outline == place) ++own;
    if (by_residual_) measure_way(outlines_, sides, place, ways_);
    if (by_turns_) find_turns(outlines_, sides, place, runs.first(own), turn_rule_, turns_);
    runs = runs.subspan(own);
  }
}

}  // namespace stope::topology
