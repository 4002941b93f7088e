#pragma once

#include <set>
#include <string>
#include <vector>

#include "framework/cache/stage_keys.hpp"
#include "framework/pipeline/plan.hpp"

namespace stope {

/// A plan to be merged with others.
struct PlanToMerge {
  std::string name;  ///< the arm's, for names of stages that only some have
  const Plan* plan = nullptr;
  const std::vector<StageKey>* keys = nullptr;
};

/// Several plans as one: what is the same in them stands in it once.
struct MergedPlan {
  Plan plan;                                     ///< without outputs
  std::vector<std::vector<std::size_t>> places;  ///< by arm and stage of its plan: in `plan`
  std::vector<std::vector<std::size_t>> owners;  ///< by stage of `plan`: the arms that have it

  PlannedSource source(std::size_t arm, const PlannedSource& in_arm) const {
    return {places[arm][in_arm.stage], in_arm.port};
  }
};

/// Merges plans by equal keys. A stage that all arms have, or that is one in all that have one of
/// its name, keeps its name; one of several that share a name gets its arms' behind it: `roads
/// (voronoi)`. Either way it draws its randomness from its own name, so it gives the bytes that it
/// would give in its arm's plan alone. Linear in the number of stages.
MergedPlan merge_plans(const std::vector<PlanToMerge>& arms);

/// The same without what only these arms have; names stay. Their places mean nothing any more.
MergedPlan without_arms(const MergedPlan& merged, const std::set<std::size_t>& arms);

}  // namespace stope
