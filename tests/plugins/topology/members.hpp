#pragma once

#include <functional>
#include <string>
#include <vector>

#include "plugins/topology/extract_roads.hpp"

namespace stope::topology {

/// Every way to extract roads, with default parameters but the ones given.
struct Member {
  std::string name;
  std::function<RoadGraph(const OccupancyGrid&, const ExtractionParams&)> extract;
  bool has_dead_ends = true;
};

inline std::vector<Member> members() {
  using Grid = OccupancyGrid;
  using Params = ExtractionParams;
  return {
      {"voronoi", [](const Grid& grid, const Params& p) { return voronoi_roads(grid, p, {}); }},
      {"skeleton by chord residual",
       [](const Grid& grid, const Params& p) { return skeleton_roads(grid, p, {}, {}); }},
      {"skeleton by lambda",
       [](const Grid& grid, const Params& p) {
         return skeleton_roads(grid, p, {}, {SkeletonParams::Pruning::kLambda});
       }},
      {"watershed of parts",
       [](const Grid& grid, const Params& p) { return watershed_part_roads(grid, p, {}, {}); }},
      {"watershed", [](const Grid& grid, const Params& p) { return watershed_roads(grid, p); },
       false},
  };
}

}  // namespace stope::topology
