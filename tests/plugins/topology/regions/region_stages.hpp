#pragma once

#include <array>

#include "stope/plugin.hpp"
#include "stope/stope.hpp"
#include "tests/plugins/stage_harness.hpp"
#include "tests/plugins/topology/test_grids.hpp"

extern "C" const stope::StageEntry* stope_stage_RegionGrowing();
extern "C" const stope::StageEntry* stope_stage_VoronoiRegions();
extern "C" const stope::StageEntry* stope_stage_Voronoi();

namespace stope::topology {

using stope::testing::error_of;
using stope::testing::StageHarness;

inline std::array<const StageEntry*, 2> region_stages() {
  return {stope_stage_RegionGrowing(), stope_stage_VoronoiRegions()};
}

/// A stage with lengths for rooms instead of mines.
inline StageHarness for_rooms(const StageEntry* entry) {
  StageHarness stage(entry);
  stage.set("min_clearance", 0.2).set("min_obstacle_area", 0.5).set("simplify", 0.05);
  stage.set("min_region_area", 1.0);
  if (entry == stope_stage_RegionGrowing())
    stage.set("growth_radius", 1.2)
        .set("max_radius", 3.0)
        .set("second_radius", 3.0)
        .set("merge_radius", 0.8)
        .set("merge_area", 30.0);
  return stage;
}

/// Two rooms of 4 x 4 m with a door of 1 m, in cells of 0.1 m.
inline OccupancyGrid two_rooms() {
  return grid_where(8.8, 4.4, 0.1, [](double x, double y) {
    const bool room = x > 0.2 && x < 8.6 && y > 0.2 && y < 4.2;
    const bool wall = x > 4.2 && x < 4.6 && !(y > 1.7 && y < 2.7);
    return room && !wall;
  });
}

/// Four rooms of 4 x 4 m, each with a door to the next and the last to the first.
inline OccupancyGrid four_rooms_in_a_ring() {
  return grid_where(8.8, 8.8, 0.1, [](double x, double y) {
    const bool room = x > 0.2 && x < 8.6 && y > 0.2 && y < 8.6;
    const auto door = [](double t) { return (t > 1.7 && t < 2.7) || (t > 6.1 && t < 7.1); };
    const bool wall = (x > 4.2 && x < 4.6 && !door(y)) || (y > 4.2 && y < 4.6 && !door(x));
    return room && !wall;
  });
}

}  // namespace stope::topology
