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
  bool operator==(const LinePoint&) const = default;
};

double distance_between(const LinePoint& a, const LinePoint& b);
double length_of(const std::vector<LinePoint>& points);

/// A centre line between two nodes, or around from one node to itself.
struct Line {
  std::int32_t from = 0, to = 0;  ///< places in LineNetwork::nodes
  std::vector<LinePoint> points;  ///< first and last are the nodes' places; none: no longer there
  double length = 0;              ///< of its points; whoever changes them sets it
  bool erased() const { return points.empty(); }
};

/// Centre lines while they are worked on. The steps that work on them break ties by the order of
/// nodes and lines: it must follow from geometry alone.
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
