#include <fmt/format.h>

#include <memory>

#include "plugins/source/synthetic_pit/truth.hpp"
#include "plugins/source/synthetic_pit/world.hpp"
#include "stope/stope.hpp"

namespace stope::source {
namespace {

class SyntheticPit final : public Stage {
 public:
  using Params = PitParameters;
  Params params;
  Out<LidarScan> scans;
  Out<StampedPose> poses;
  OutValue<Trajectory> trajectory;
  OutValue<OccupancyGrid> truth_grid;
  OutValue<RoadGraph> truth_roads;
  OutValue<ElevationGrid> truth_elevation;

  static void describe(About<SyntheticPit>& about);
  void run(Context& context) override;
};

void SyntheticPit::describe(About<SyntheticPit>& about) {
  about
      .summary(
          "An open pit with benches, ramps, haul roads, berms and parked machines, scanned by a "
          "truck that drives through it, and the truth about it.")
      .notes(
          "Every seed is another mine. The true road graph holds the roads as designed; edges lie "
          "half a width to both sides except near junctions and turning places (see "
          "docs/synthetic_pit.md). Below 300 m the map is a yard at the bottom of a pit.")
      .output("scans", &SyntheticPit::scans,
              "Sweeps with ring, intensity, per-point time and true label.")
      .output("poses", &SyntheticPit::poses, "The true pose at each scan's stamp.")
      .output("trajectory", &SyntheticPit::trajectory,
              "The true motion, dense enough to undo it within a sweep.")
      .output("truth_grid", &SyntheticPit::truth_grid, "Where a truck can drive; nothing unknown.")
      .output("truth_roads", &SyntheticPit::truth_roads,
              "True centre lines with widths and elevations.")
      .output("truth_elevation", &SyntheticPit::truth_elevation,
              "Height of the ground without machines.")
      .param("size", &Params::size, "m", between(100, 6000), "Side of the square map.")
      .param("benches", &Params::benches, between(1, 40),
             "Steps from the surface to the pit's floor.")
      .param("bench_height", &Params::bench_height, "m", between(2, 30), "Height of one step.")
      .param("road_width", &Params::road_width, "m", between(6, 40),
             "Width of all roads, between the feet of their berms.")
      .param("grade", &Params::grade, between(0.03, 0.15),
             "Steepest slope of a ramp, rise over run.")
      .param("dead_ends", &Params::dead_ends, between(0, 400),
             "Loading faces, dumps and yards to aim at; fewer where there is no room.")
      .param("connectors", &Params::connectors, between(0, 200),
             "Roads that close further loops to aim at; fewer where there is no room.")
      .param("rough", &Params::rough, "m", between(0, 3), "Amplitude of freshly dug faces.")
      .param("objects", &Params::objects, between(0, 6),
             "Machines parked around each turning place, on average.")
      .param("resolution", &Params::resolution, "m", between(0.1, 2),
             "Cell of the height field and of the truth grids.")
      .param("truck_speed", &Params::truck_speed, "m/s", between(0.5, 25),
             "Speed on straight roads; less in bends.")
      .param("route_length", &Params::route_length, "m", at_least(0),
             "Stop after this distance; 0 drives the whole network.")
      .param("scans", &Params::scans, at_least(0),
             "Stop after this many scans; 0 takes as many as the route gives.")
      .param("stride", &Params::stride, between(1, 1000),
             "Keep one sweep of this many; 1 for odometry.")
      .param("rings", &Params::rings, between(16, 64), "Lasers of the sensor: 16, 32 or 64.")
      .param("azimuths", &Params::azimuths, between(36, 4096), "Firings a turn.")
      .param("scan_rate", &Params::scan_rate, "Hz", between(1, 50), "Turns a second.")
      .param("range_noise", &Params::range_noise, "m", between(0, 1),
             "Standard deviation of ranges.")
      .param("dropout", &Params::dropout, between(0, 1), "Share of the returns that are lost.")
      .param("max_range", &Params::max_range, "m", between(5, 500), "Nothing is seen further away.")
      .param("sensor_height", &Params::sensor_height, "m", between(1, 8),
             "Height of the LiDAR over the road.");
}

void SyntheticPit::run(Context& context) {
  if (params.rings != 16 && params.rings != 32 && params.rings != 64)
    throw Error(fmt::format("rings is {}, but the sensors known here have 16, 32 or 64 rings",
                            params.rings));
  const Checkpoint checkpoint = [&context] { context.stop_if_cancelled(); };
  const auto world = std::make_shared<const World>(params, context.seed(), checkpoint);
  const Sweeps& sweeps = world->sweeps;
  context.info(fmt::format("{} roads, {} junctions and dead ends, {:.1f} km driven, {} scans",
                           world->graph.edges.size(), world->graph.nodes.size(),
                           world->drive.distance_at(world->drive.duration()) / 1000, sweeps.count));
  trajectory.set(world->trajectory);
  context.stop_if_cancelled();
  if (truth_grid.wanted()) truth_grid.set(true_grid(world->terrain));
  context.stop_if_cancelled();
  if (truth_elevation.wanted()) truth_elevation.set(true_elevation(world->terrain));
  if (truth_roads.wanted()) truth_roads.set(true_roads(world->graph, world->terrain, checkpoint));

  const std::size_t bytes = static_cast<std::size_t>(params.rings * params.azimuths) * 23;
  for (std::size_t k = 0; k < sweeps.count; ++k) {
    context.stop_if_cancelled();
    const Stamp stamp = sweeps.end(k);
    scans.put_lazy(
        stamp, [world, k] { return world->scan(k); }, bytes);
    if (poses.wanted()) poses.put(stamp, {stamp, pose_at(world->trajectory, stamp)});
    context.progress(static_cast<double>(k + 1) / static_cast<double>(sweeps.count));
  }
}

}  // namespace

STOPE_STAGE(SyntheticPit, "source/synthetic_pit");

}  // namespace stope::source
