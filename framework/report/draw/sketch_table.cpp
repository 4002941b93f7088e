#include "framework/report/draw/sketch_table.hpp"

#include "framework/report/draw/sketches.hpp"

namespace stope::report {
namespace {

// The function for the first of the payloads whose type it is.
template <class... Payloads>
SketchFunction function_among(std::string_view type) {
  SketchFunction found;
  const auto look = [&]<class T>(const T*) {
    if (type == T::kType)
      found = [](const void* payload) { return sketch_of(*static_cast<const T*>(payload)); };
  };
  (look(static_cast<const Payloads*>(nullptr)), ...);
  return found;
}

}  // namespace

SketchFunction sketch_function(std::string_view type) {
  return function_among<OccupancyGrid, ElevationGrid, DistanceGrid, LabelGrid, RegionMap, RoadGraph,
                        Path, Trajectory, PoseGraph, LineSet, PointCloud, LidarScan, Measures>(
      type);
}

}  // namespace stope::report
