#include "plugins/source/synthetic_pit/world.hpp"

#include "plugins/source/synthetic_pit/route.hpp"
#include "stope/random.hpp"

namespace stope::source {

World::World(const PitParameters& parameters, std::uint64_t seed_, const Checkpoint& checkpoint)
    : seed(seed_),
      layout(plan_layout(parameters, seed_, checkpoint)),
      graph(cut_at_junctions(layout.network)),
      machines(park_machines(layout, parameters, seed_)),
      terrain(build_terrain(layout, parameters, machines.pads, seed_, checkpoint)),
      pyramid(terrain, checkpoint),
      drive(route_line(layout.network, graph, covering_route(graph, checkpoint), layout.rules,
                       checkpoint),
            terrain, parameters, checkpoint),
      sweeps(plan_sweeps(drive, parameters)),
      trajectory(true_trajectory(drive, sweeps, checkpoint)),
      lidar(parameters) {}

LidarScan World::scan(std::size_t k) const {
  return lidar.sweep(terrain, pyramid, machines.boxes, trajectory, sweeps.begin(k), sweeps.end(k),
                     mix_seed(mix_seed(seed, 50), k));
}

}  // namespace stope::source
