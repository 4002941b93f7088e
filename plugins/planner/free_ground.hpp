#pragma once

#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>

#include <cstdint>
#include <functional>
#include <vector>

#include "plugins/planner/drivable_grid.hpp"
#include "plugins/planner/requested_changes.hpp"
#include "plugins/planner/road_network.hpp"
#include "stope/random.hpp"

namespace stope::planner {

/// The free ground around a road network as OMPL sees it: points of the grid's plane, valid where
/// the cell is free, has the clearance asked, and lies in no disc of clearance of a road that is
/// closed or one-way (which OMPL's undirected roadmaps know nothing of). Keeps references to both.
class FreeGround {
 public:
  FreeGround(const DrivableGrid& grid, const RoadNetwork& network,
             const RequestedChanges& requested, double snap_distance);

  /// A plane bounded by the grid, whose states are checked here, and which draws its samples with
  /// `draw`. Every generator of random numbers is the caller's: OMPL's own are seeded once a
  /// process and would depend on what ran before.
  ompl::base::SpaceInformationPtr space(std::function<void(double* xy)> draw) const;
  /// A point within the clearance of a random place on a road that may be driven.
  void draw(Random& random, double* xy) const;
  bool valid(const Vector2& point) const;
  bool sees(const Vector2& a, const Vector2& b) const;
  double clearance(const Vector2& point) const;
  /// Height of the road nearest to a point; NaN if there is none with a height.
  double height(const Vector2& point) const;

 private:
  struct Stretch {
    std::uint32_t edge;
    double until;  // metres of road so far
  };
  const DrivableGrid& grid_;
  const RoadNetwork& network_;
  std::vector<bool> forbidden_;  // cells
  std::vector<Stretch> stretches_;
};

}  // namespace stope::planner
