#pragma once

#include <string>
#include <vector>

#include "plugins/planner/drivable_grid.hpp"
#include "plugins/planner/far_ends.hpp"
#include "plugins/planner/grid_link.hpp"
#include "plugins/planner/plan_request.hpp"
#include "plugins/planner/road_changes.hpp"
#include "plugins/planner/road_network.hpp"
#include "plugins/planner/road_snap.hpp"

namespace stope::planner {

/// "(12.00, 34.50)"
std::string text_of_point(const Vector2& point);
/// Where a place on a road lies.
Vector2 position_of(const RoadNetwork& network, RoadPlace place);

/// Where a plan begins and ends: the start and goal asked for, joined to roads, or far ends of the
/// network where they are left out. Keeps references; `changes` may change in between.
class PlanEnds {
 public:
  /// `grid` may be null. Throws Error where start or goal cannot be used; the sentence names the
  /// nearest place that can.
  PlanEnds(const RoadNetwork& network, const DrivableGrid* grid, const PlanRequest& request,
           const RoadChanges& changes, const Say& say);

  const Link& start() const { return start_; }
  const Link& goal() const { return goal_; }
  /// Throws Error: the goal cannot be had from the start, `why`, and what can be instead.
  [[noreturn]] void refuse_goal(const std::string& why) const;

 private:
  void choose();
  Link take_far(const char* which, const FarPlace& end, const char* other) const;
  Link take(const char* which, RoadPlace place, const char* what, const std::string& why) const;
  Link link(const char* which, const std::vector<double>& numbers) const;
  std::vector<SnappedPlace> open_places(const Vector2& point) const;
  std::vector<SnappedPlace> useful_places(const std::string& which, const Vector2& point) const;
  Vector2 nearest_drivable(const char* which, const Vector2& point) const;

  const RoadNetwork& network_;
  const DrivableGrid* grid_;
  const PlanRequest& request_;
  const RoadChanges& changes_;
  const Say& say_;
  Link start_, goal_;
};

}  // namespace stope::planner
