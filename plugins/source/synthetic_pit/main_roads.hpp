#pragma once

#include <optional>
#include <vector>

#include "plugins/source/synthetic_pit/layout.hpp"
#include "stope/random.hpp"

namespace stope::source {

/// The closed road around the pit, on the surface.
Street ring_road(const PitShape& shape, const PitParameters& parameters);

/// The closed road on the pit's floor. Throws Error if the floor is too small for it.
Street floor_loop(const PitShape& shape, const PitParameters& parameters);

/// A ramp with the stations of the level landings where it passes a bench.
struct Ramp {
  Proposal proposal;
  std::vector<double> landings;  ///< metres along the ramp, middle of each
};

/// How a ramp goes down.
struct RampPlan {
  double angle = 0;         ///< where it leaves the ring road, seen from the pit's centre
  double turn = 1;          ///< 1: counter-clockwise, -1: clockwise
  bool switchback = false;  ///< turns round half-way down
  double grade = 0.08;      ///< between landings
};

/// A ramp from street `ring` to street `loop`; none if its bends or its length do not come out.
std::optional<Ramp> ramp_road(const Layout& layout, const PitParameters& parameters,
                              std::size_t ring, std::size_t loop, const RampPlan& plan);

/// The point of a street that lies nearest to the direction `angle` from the pit's centre.
std::size_t point_towards(const Layout& layout, const Street& street, double angle);

}  // namespace stope::source
