#pragma once

#include "framework/report/sketch.hpp"
#include "stope/payloads.hpp"

/// The sketch of each payload that can be drawn. Their cost is bounded by that of the picture, not
/// by the payload, but for one pass over points and lines.
namespace stope::report {

Sketch sketch_of(const OccupancyGrid& grid);
Sketch sketch_of(const ElevationGrid& grid);
Sketch sketch_of(const DistanceGrid& grid);
Sketch sketch_of(const LabelGrid& grid);
Sketch sketch_of(const RegionMap& map);
Sketch sketch_of(const RoadGraph& graph);
Sketch sketch_of(const Path& path);
Sketch sketch_of(const Trajectory& trajectory);
Sketch sketch_of(const PoseGraph& graph);
Sketch sketch_of(const LineSet& lines);
Sketch sketch_of(const PointCloud& cloud);
Sketch sketch_of(const LidarScan& scan);
Sketch sketch_of(const Measures& measures);

}  // namespace stope::report
