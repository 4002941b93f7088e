#pragma once

#include <memory>

#include "plugins/source/synthetic_pit/checkpoint.hpp"
#include "plugins/source/synthetic_pit/drive.hpp"
#include "plugins/source/synthetic_pit/layout.hpp"
#include "plugins/source/synthetic_pit/machines.hpp"
#include "plugins/source/synthetic_pit/network_graph.hpp"
#include "plugins/source/synthetic_pit/sensor.hpp"
#include "plugins/source/synthetic_pit/terrain.hpp"

namespace stope::source {

/// A synthetic pit, finished: everything that scans and truth are read off. Immutable, and a
/// function of parameters and seed. Its parts are made in the order of its members, each from those
/// before it; what later sensors or a second epoch need hooks in between.
struct World {
  /// Throws what `checkpoint` throws.
  World(const PitParameters& parameters, std::uint64_t seed,
        const Checkpoint& checkpoint = never_stop);
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  std::uint64_t seed;
  Layout layout;
  NetworkGraph graph;
  Machines machines;
  Terrain terrain;
  HeightPyramid pyramid;
  Drive drive;
  Sweeps sweeps;
  Trajectory trajectory;
  SpinningLidar lidar;

  /// Sweep k: the same bytes whenever and wherever it is asked for.
  LidarScan scan(std::size_t k) const;
};

}  // namespace stope::source
