#pragma once

#include <cstdint>
#include <vector>

#include "plugins/topology/padded_grid.hpp"

namespace stope::topology {

/// A point of a centre line, in cells from the lower left corner of the grid (a cell's centre is
/// half a cell further), with its distance to the centre of the nearest obstacle cell.
struct LinePoint {
  double x = 0, y = 0;
  double distance = 0;
};

double distance_between(const LinePoint& a, const LinePoint& b);

/// A centre line between two nodes, or around from one node to itself.
struct Line {
  std::int32_t from = 0, to = 0;  ///< places in LineNetwork::nodes
  std::vector<LinePoint> points;  ///< first and last are the nodes' places; none: no longer there
  bool erased() const { return points.empty(); }
  double length() const;
};

/// Centre lines while they are worked on.
struct LineNetwork {
  struct Node {
    LinePoint point;
    bool alone = false;  ///< stands for a piece of free space without lines
  };
  std::vector<Node> nodes;
  std::vector<Line> lines;

  /// The lines that end at each node; one from a node to itself is there twice.
  std::vector<std::vector<std::int32_t>> lines_at_nodes() const;
  /// Joins lines that meet two and two, and removes erased lines and nodes nothing ends at, unless
  /// they are alone. A ring without a junction keeps one node.
  void tidy();
};

}  // namespace stope::topology
