#pragma once

#include <array>

#include "plugins/topology/line_network.hpp"
#include "plugins/topology/looked_at.hpp"
#include "plugins/topology/outlines.hpp"

namespace stope::topology {

/// The distance to the nearest obstacle cell's centre from any place of a map. `edges` are the
/// nearest ones of all cells: none may have been given a neighbour's.
class DistanceField {
 public:
  DistanceField(const Outlines& outlines, const EdgeGrid& edges, const FreeSpace& space)
      : outlines_(outlines), edges_(edges), space_(space) {}

  /// At a place, by what the cells up to `reach` columns and rows away see; its own distance if
  /// none of them is free. Too large where none of them sees the nearest obstacle, by at most 0.3
  /// cells for a reach of 1.
  double at(const LinePoint& place, std::int32_t reach) const;

  /// The same, with a reach of 1, of all points of a line.
  void estimate(std::vector<LinePoint>& line) const;

  /// Gives the points of a line their distances, and the line another point where it is nearest to
  /// an obstacle, if that is between two of them: no place of the line is nearer to one, but for
  /// 1e-6 cells. `looked_at`, if given, is told what that depends on. Cost: a few steps a row of
  /// the circle around each point; where the distance is nearly the least, one look a cell;
  /// elsewhere far fewer, because it changes by no more than the way (Piyavskii 1972).
  void measure(std::vector<LinePoint>& line, LookedAt* looked_at = nullptr) const;

 private:
  static constexpr std::int32_t kReach = 2;
  struct Narrowest {
    LinePoint place;
    std::size_t before = 0;  ///< which point of the line it lies; 0: it is one of them
  };
  /// A free cell's centre, and the obstacle cell's that is nearest to it.
  struct Cell {
    double x = 0, y = 0, site_x = 0, site_y = 0;
    double distance = 0;
  };
  struct Surroundings {
    std::array<Cell, (2 * kReach + 1) * (2 * kReach + 1)> cells;
    std::size_t count = 0;
    const Cell* begin() const { return cells.data(); }
    const Cell* end() const { return cells.data() + count; }
  };
  template <class Visit>
  void for_each_site(const LinePoint& place, std::int32_t reach, Visit visit) const;
  CellIndex cell_at(const LinePoint& place) const;
  Surroundings look_around(const LinePoint& place) const;
  bool probe(std::int32_t column, std::int32_t row, LookedAt* looked_at) const;
  double exactly_at(const LinePoint& place, LookedAt* looked_at) const;
  void search_quarter(const LinePoint& place, const Surroundings& around, double to_x, double to_y,
                      double& least, LookedAt* looked_at) const;
  void search(const LinePoint& from, const LinePoint& to, std::size_t before, Narrowest& best,
              LookedAt* looked_at) const;
  void search_beside(const LinePoint& from, const LinePoint& to, const Surroundings& around,
                     std::size_t before, Narrowest& best, LookedAt* looked_at) const;

  const Outlines& outlines_;
  const EdgeGrid& edges_;
  const FreeSpace& space_;
};

}  // namespace stope::topology
