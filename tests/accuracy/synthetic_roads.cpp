#include "synthetic_roads.hpp"

#include "stope/testing/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_SyntheticPit();
extern "C" const stope::StageEntry* stope_stage_PointCloud();
extern "C" const stope::StageEntry* stope_stage_HeightDifference();
extern "C" const stope::StageEntry* stope_stage_TrajectoryDilation();
extern "C" const stope::StageEntry* stope_stage_Maximum();
extern "C" const stope::StageEntry* stope_stage_Voronoi();
extern "C" const stope::StageEntry* stope_stage_Skeleton();
extern "C" const stope::StageEntry* stope_stage_Watershed();

namespace stope::testing {
namespace {

OccupancyGrid mapped_grid(MemoryInput<LidarScan>& scans, const Trajectory& trajectory) {
  MemoryInput<Trajectory> poses;
  poses.add(0, trajectory);
  MemoryOutput<PointCloud> cloud;
  StageHarness(stope_stage_PointCloud())
      .connect_input("scans", scans)
      .connect_input("trajectory", poses)
      .connect_output("cloud", cloud)
      .run();
  const auto live = StageHarness(stope_stage_HeightDifference())
                        .input("cloud", *cloud.items.at(0).value)
                        .input("trajectory", trajectory)
                        .apply<OccupancyGrid>();
  const auto prior = StageHarness(stope_stage_TrajectoryDilation())
                         .set("width", 16.0)
                         .input("trajectory", trajectory)
                         .apply<OccupancyGrid>();
  return StageHarness(stope_stage_Maximum())
      .input("prior", prior)
      .input("live", live)
      .apply<OccupancyGrid>();
}

}  // namespace

SyntheticRoads synthetic_roads(double size, std::uint64_t seed, std::optional<double> rough) {
  StageHarness pit(stope_stage_SyntheticPit());
  pit.context().reseed(seed);
  MemoryOutput<OccupancyGrid> grid;
  MemoryOutput<RoadGraph> roads;
  if (rough) pit.set("rough", *rough);
  pit.set("size", size).connect_output("truth_grid", grid).connect_output("truth_roads", roads);
  pit.run();
  return {*grid.items.at(0).value, *roads.items.at(0).value};
}

SyntheticRoads mapped_roads(std::uint64_t seed) {
  StageHarness pit(stope_stage_SyntheticPit());
  pit.context().reseed(seed);
  MemoryOutput<LidarScan> scans;
  MemoryOutput<Trajectory> trajectory;
  MemoryOutput<RoadGraph> roads;
  pit.connect_output("scans", scans)
      .connect_output("trajectory", trajectory)
      .connect_output("truth_roads", roads);
  pit.run();
  MemoryInput<LidarScan> recorded;
  for (const auto& scan : scans.items) recorded.add(scan.stamp, *scan.value);
  scans.items.clear();
  return {mapped_grid(recorded, *trajectory.items.at(0).value), *roads.items.at(0).value};
}

RoadGraph extract_roads(const OccupancyGrid& grid, Extractor extractor) {
  const bool watershed =
      extractor == Extractor::kWatershed || extractor == Extractor::kWatershedOfParts;
  StageHarness stage(extractor == Extractor::kVoronoi ? stope_stage_Voronoi()
                     : watershed                      ? stope_stage_Watershed()
                                                      : stope_stage_Skeleton());
  if (extractor == Extractor::kSkeletonByLambda) stage.set("pruning", std::string("lambda"));
  if (extractor == Extractor::kWatershedOfParts) stage.set("sites", std::string("outline_parts"));
  return stage.input("grid", grid).apply<RoadGraph>();
}

}  // namespace stope::testing
