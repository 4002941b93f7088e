#pragma once

#include "plugins/topology/line_network.hpp"
#include "plugins/topology/outlines.hpp"

namespace stope::topology {

/// The distance to the nearest obstacle cell's centre from any place, as the free cells around it
/// see obstacles: a little too large where none of them sees the nearest one, by at most 0.3 cells
/// with the nine cells around, 0.1 with 25.
class DistanceField {
 public:
  DistanceField(const Outlines& outlines, const EdgeGrid& edges, const FreeSpace& space)
      : outlines_(outlines), edges_(edges), space_(space) {}

  /// At a place, by what the cells up to `reach` columns and rows away see; its own distance if
  /// none of them is free.
  double at(const LinePoint& place, std::int32_t reach) const;

  /// Gives the points of a line their distances, and the line another point where it is nearest to
  /// an obstacle, if that is between two of them. `looked_at`, if given, gets places beside or in
  /// all cells that the answer depends on. Cost: where the distance is nearly the least, one look a
  /// cell; elsewhere far fewer, because it changes by no more than the way (Piyavskii 1972).
  void measure(std::vector<LinePoint>& line, std::vector<LinePoint>* looked_at = nullptr) const;

 private:
  static constexpr std::int32_t kReach = 2;
  struct Narrowest {
    LinePoint place;
    std::size_t before = 0;  ///< which point of the line it lies; 0: it is one of them
  };
  template <class Visit>
  void for_each_site(const LinePoint& place, std::int32_t reach, Visit visit) const;
  void search(const LinePoint& from, const LinePoint& to, std::size_t before, Narrowest& best,
              std::vector<LinePoint>* looked_at) const;

  const Outlines& outlines_;
  const EdgeGrid& edges_;
  const FreeSpace& space_;
};

}  // namespace stope::topology
