#include "fake_catalogue.hpp"

#include <algorithm>

#include "stope/stope.hpp"

namespace stope {
namespace {

// Declares a stage in the order a person reads it.
class Declaration {
 public:
  explicit Declaration(std::string id) { info_.id = std::move(id); }
  Declaration&& map() && { return info_.map = true, std::move(*this); }
  template <class T>
  Declaration&& stream(std::string name) && {
    info_.inputs.push_back(traits::port_info<T>(std::move(name), true, true, ""));
    return std::move(*this);
  }
  template <class T>
  Declaration&& value(std::string name) && {
    info_.inputs.push_back(traits::port_info<T>(std::move(name), false, true, ""));
    return std::move(*this);
  }
  template <class T>
  Declaration&& optional(std::string name) && {
    info_.inputs.push_back(traits::port_info<T>(std::move(name), false, false, ""));
    return std::move(*this);
  }
  template <class T>
  Declaration&& gives_stream(std::string name) && {
    info_.outputs.push_back(traits::port_info<T>(std::move(name), true, true, ""));
    return std::move(*this);
  }
  template <class T>
  Declaration&& gives(std::string name) && {
    info_.outputs.push_back(traits::port_info<T>(std::move(name), false, true, ""));
    return std::move(*this);
  }
  template <class T>
  Declaration&& param(std::string name, T initial, std::string unit, Limits limits = {}) && {
    using Traits = ParameterTraits<T>;
    info_.parameters.push_back({std::move(name), Traits::kind(), Traits::kOptional,
                                Traits::to_value(initial), std::move(unit),
                                Traits::implied_limits() + limits, ""});
    return std::move(*this);
  }
  Declaration&& writes(std::vector<std::string> extensions) && {
    info_.extensions = std::move(extensions);
    return std::move(*this).gives<Artefact>("artefact");
  }
  StageInfo take() && { return std::move(info_); }

 private:
  StageInfo info_;
};

using Stages = std::vector<StageInfo>;
Declaration stage(std::string id) { return Declaration(std::move(id)); }

void add_sources(Stages& all) {
  all.push_back(
      stage("source/kitti")
          .gives_stream<LidarScan>("scans")
          .gives_stream<StampedPose>("poses")
          .gives<Trajectory>("trajectory")
          .param("scans", std::filesystem::path(), "", required() + existing(PathKind::kFolder))
          .param("poses", std::filesystem::path(), "", required() + existing(PathKind::kFile))
          .param("rate", 10.0, "Hz", more_than(0.0))
          .take());
  all.push_back(stage("source/synthetic_pit")
                    .gives_stream<LidarScan>("scans")
                    .gives<Trajectory>("trajectory")
                    .param("extent", 400.0, "m", between(150, 4000))
                    .param("rings", 32, "", between(1, 128))
                    .param("turns", 1.0, "Hz", more_than(0.0) + at_most(20))
                    .take());
  all.push_back(
      stage("map_source/map_server")
          .gives<OccupancyGrid>("grid")
          .param("map", std::filesystem::path(), "", required() + existing(PathKind::kFile))
          .take());
}

void add_mapping(Stages& all) {
  all.push_back(stage("map/point_cloud")
                    .stream<LidarScan>("scans")
                    .value<Trajectory>("trajectory")
                    .gives<PointCloud>("cloud")
                    .param("voxel", 0.2, "m", at_least(0.0))
                    .take());
  all.push_back(stage("map/voxels")
                    .stream<LidarScan>("scans")
                    .value<Trajectory>("trajectory")
                    .gives<VoxelMap>("voxels")
                    .param("dense", false, "")
                    .param("levels", 3, "", between(1, 8))
                    .param("memory", std::int64_t{1} << 20, "B", at_least(1024))
                    .param("share", 0.5, "", between(0, 1))
                    .param("speed", 10.0, "m/s", more_than(0))
                    .param("area", 100.0, "m^2")
                    .param("yaw", 0.0, "rad", between(-3.2, 3.2))
                    .param("window", 2.0, "s", at_least(0))
                    .param("weights", std::vector<double>{1}, "", count(1, 4) + at_least(0))
                    .param("labels", std::vector<std::string>{"ground"}, "",
                           one_of({"ground", "wall", "berm", "object"}))
                    .param("mode", std::string("mean"), "", one_of({"mean", "median", "maximum"}))
                    .param("note", std::optional<std::string>(), "")
                    .take());
  all.push_back(stage("rasterizer/height_difference")
                    .map()
                    .stream<PointCloud>("cloud")
                    .gives_stream<OccupancyGrid>("grid")
                    .param("resolution", 0.5, "m", more_than(0.0))
                    .param("height", 0.5, "m", more_than(0.0))
                    .take());
  all.push_back(stage("rasterizer/drivable")
                    .map()
                    .stream<PointCloud>("cloud")
                    .gives_stream<OccupancyGrid>("grid")
                    .param("resolution", 0.5, "m", more_than(0.0))
                    .param("slope", 0.2, "rad", between(0.0, 1.5))
                    .take());
  all.push_back(stage("prior/trajectory_dilation")
                    .map()
                    .stream<Trajectory>("trajectory")
                    .gives_stream<OccupancyGrid>("grid")
                    .param("width", 8.0, "m", more_than(0.0))
                    .take());
  all.push_back(stage("fusion/maximum")
                    .map()
                    .stream<OccupancyGrid>("prior")
                    .stream<OccupancyGrid>("live")
                    .gives_stream<OccupancyGrid>("grid")
                    .take());
  // Per scan, so that there is a stream of clouds.
  all.push_back(stage("filter/range")
                    .map()
                    .stream<LidarScan>("scans")
                    .gives_stream<PointCloud>("cloud")
                    .take());
}

void add_roads(Stages& all) {
  all.push_back(stage("topology/watershed")
                    .map()
                    .stream<OccupancyGrid>("grid")
                    .gives_stream<RoadGraph>("roads")
                    .param("min_clearance", 3.0, "m", at_least(0.0))
                    .take());
  all.push_back(stage("topology/voronoi")
                    .map()
                    .stream<OccupancyGrid>("grid")
                    .gives_stream<RoadGraph>("roads")
                    .param("min_clearance", 3.0, "m", at_least(0.0))
                    .param("prune", 5.0, "m", at_least(0.0))
                    .take());
  all.push_back(stage("topology/region_growing")
                    .map()
                    .stream<OccupancyGrid>("grid")
                    .stream<Trajectory>("seeds")
                    .gives_stream<RoadGraph>("roads")
                    .take());
  const auto planner = [](std::string id) {
    return stage(std::move(id))
        .value<RoadGraph>("roads")
        .param("start", std::optional<std::array<double, 2>>(), "m")
        .param("goal", std::optional<std::array<double, 2>>(), "m");
  };
  all.push_back(
      planner("planner/a_star").optional<OccupancyGrid>("grid").gives<Path>("path").take());
  all.push_back(planner("planner/direct").gives<Path>("path").take());
  all.push_back(stage("metric/ate")
                    .value<Trajectory>("trajectory")
                    .value<Trajectory>("truth")
                    .gives<Measures>("measures")
                    .take());
}

void add_exports(Stages& all) {
  all.push_back(stage("export/png")
                    .map()
                    .stream<OccupancyGrid>("grid")
                    .optional<RoadGraph>("roads")
                    .optional<Path>("path")
                    .writes({"png"})
                    .param("width", 1600, "", between(16, 20000))
                    .take());
  all.push_back(stage("export/map_server")
                    .map()
                    .stream<OccupancyGrid>("grid")
                    .writes({"yaml"})
                    .param("mode", std::string("trinary"), "", one_of({"trinary", "scale", "raw"}))
                    .param("stem", std::string("map"), "")
                    .take());
  all.push_back(
      stage("export/nav2_route").map().stream<RoadGraph>("roads").writes({"geojson"}).take());
  all.push_back(stage("export/path").map().stream<Path>("path").writes({"geojson"}).take());
  all.push_back(
      stage("export/graphml").map().stream<RoadGraph>("roads").writes({"graphml"}).take());
  all.push_back(stage("export/tum").map().stream<Trajectory>("trajectory").writes({"tum"}).take());
  all.push_back(stage("export/pcd").map().stream<PointCloud>("cloud").writes({"pcd"}).take());
  all.push_back(stage("export/ply").map().stream<PointCloud>("cloud").writes({"ply"}).take());
  all.push_back(stage("export/packed").map().stream<PointCloud>("cloud").writes({"pcd.gz"}).take());
  all.push_back(stage("export/las").map().stream<PointCloud>("cloud").writes({"las"}).take());
  all.push_back(stage("export/las_tiles").map().stream<PointCloud>("cloud").writes({"las"}).take());
}

// What a vendor with other headers offers.
void add_strangers(Stages& all) {
  StageInfo other_layout = stage("acme/scanner").gives<PointCloud>("cloud").take();
  other_layout.outputs[0].layout ^= 1;
  all.push_back(other_layout);
  StageInfo next_version = stage("acme/scanner_2").gives<PointCloud>("cloud").take();
  next_version.outputs[0].type = "stope/PointCloud@2";
  all.push_back(next_version);
  all.push_back(stage("acme/loop")
                    .map()
                    .stream<OccupancyGrid>("grid")
                    .gives_stream<OccupancyGrid>("grid")
                    .take());
  all.push_back(
      stage("acme/twins").gives<OccupancyGrid>("left").gives<OccupancyGrid>("right").take());
}

}  // namespace

FakeCatalogue::FakeCatalogue() {
  Stages all;
  add_sources(all);
  add_mapping(all);
  add_roads(all);
  add_exports(all);
  add_strangers(all);
  std::sort(all.begin(), all.end(),
            [](const StageInfo& a, const StageInfo& b) { return a.id < b.id; });
  for (StageInfo& info : all) {
    const std::string plugin = info.id.substr(0, info.id.find('/'));
    stages_.push_back({std::move(info), plugin + ".so", plugin, "1.0.0", "0123456789abcdef"});
  }
}

const StageRecord* FakeCatalogue::find(std::string_view id) const {
  for (const StageRecord& record : stages_)
    if (record.info.id == id) return &record;
  return nullptr;
}

std::unique_ptr<StageInstance> FakeCatalogue::create(std::string_view) const {
  throw Error("these stages cannot be made");
}

}  // namespace stope
