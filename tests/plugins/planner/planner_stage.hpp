#pragma once

#include <utility>
#include <vector>

#include "stope/payloads/road_graph.hpp"
#include "tests/plugins/stage_harness.hpp"

namespace stope::planner {

using Numbers = std::vector<double>;

/// A planner's stage with roads, and with start and goal unless they are empty.
inline testing::StageHarness planner_stage(const StageEntry* entry, RoadGraph roads,
                                           const Numbers& start, const Numbers& goal) {
  testing::StageHarness stage(entry);
  stage.input("roads", std::move(roads));
  if (!start.empty()) stage.set("start", start);
  if (!goal.empty()) stage.set("goal", goal);
  return stage;
}

}  // namespace stope::planner
