#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "plugins/topology/free_space.hpp"

namespace stope::topology {

/// One side of an obstacle cell that faces a free cell, by its number along the outlines.
using OutlineEdge = std::int32_t;

/// The sides of a cell.
enum Side : int { kEast = 0, kNorth = 1, kWest = 2, kSouth = 3 };

/// A closed boundary between one obstacle (4-connected) and one piece of free space (8-connected),
/// walked with the obstacle on the left.
struct Outline {
  OutlineEdge first = 0;
  std::int32_t count = 0;
  std::int32_t left = 0, right = 0, bottom = 0, top = 0;  ///< columns and rows of its cells
};

/// The outlines of all obstacles. Within one piece of free space two outlines never belong to the
/// same obstacle, so an outline stands for the obstacle.
struct Outlines {
  struct Place {
    std::int32_t column = 0, row = 0;
  };
  std::vector<Outline> list;
  std::vector<Place> place;                       ///< by edge: the obstacle cell it is a side of
  std::vector<std::int32_t> of_edge;              ///< by edge: its outline
  std::vector<std::array<OutlineEdge, 4>> sides;  ///< by outline cell: edge of each Side, or -1
  /// Numbers of edges of different outlines differ by more than this.
  std::int32_t gap = 0;
};

/// For a free cell the nearest outline edge; for an outline cell its place in Outlines::sides.
using EdgeGrid = PaddedGrid<std::int32_t>;

/// Walks all outlines, marks their cells kOnOutline and notes their place in `edges`. Obstacles
/// whose outer outline encloses less than `least_area` cells become free, with all they enclose.
/// `gap` as in Outlines. Cost: one look at every cell, then linear in the outlines' length.
Outlines trace_outlines(FreeSpace& space, EdgeGrid& edges, double least_area, std::int32_t gap,
                        const Checkpoint& checkpoint = never_stop);

}  // namespace stope::topology
