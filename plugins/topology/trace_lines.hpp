#pragma once

#include <array>
#include <utility>
#include <vector>

#include "plugins/topology/dividing_lines.hpp"
#include "plugins/topology/line_network.hpp"

namespace stope::topology {

/// A link of two places of dividing lines by a way through free cells.
struct Link {
  CellIndex from = 0, to = 0;    ///< corners
  std::vector<CellIndex> cells;  ///< the way, neighbours by side or corner; not empty
};

/// Steps of a line from `begin` to before `end`.
struct StepRange {
  std::int32_t begin = 0, end = 0;
  bool operator==(const StepRange&) const = default;
};

/// A dividing line from node to node: a node is a corner where lines meet or end, or that a link
/// ends at. A ring without a node has one at its lowest corner (by CellIndex).
struct TracedLine {
  std::vector<CellIndex> corners;      ///< that it passes, both ends included
  std::int32_t way = 0;                ///< its rank among those that start at its first corner
  std::array<OutlineEdge, 2> sides{};  ///< an edge of the outline to either side, or -1: none
  CourseId course = kNoCourse;         ///< a point a step, and before and behind them the nodes'
  /// Where the two places seen are nearer to each other than the tracer's least_apart.
  std::vector<StepRange> narrow;
  CellIndex from() const { return corners.front(); }
  CellIndex to() const { return corners.back(); }
};

/// Whether a line comes first in the order all lines are kept in: by first corner and way, which is
/// a matter of geometry alone.
inline bool comes_first(const TracedLine& a, const TracedLine& b) {
  return a.from() != b.from() ? a.from() < b.from() : a.way < b.way;
}

/// Follows dividing lines from node to node, each from its lower end. Each step gives one point,
/// accurate to a fraction of a cell: where two cells see different obstacles, the place between
/// their centres that is equally far from both.
class LineTracer {
 public:
  /// `least_apart` in cells, for TracedLine::narrow.
  LineTracer(FreeSpace& space, const Outlines& outlines, const EdgeGrid& edges, Courses& courses,
             double least_apart)
      : space_(space),
        outlines_(outlines),
        edges_(edges),
        courses_(courses),
        least_apart_(least_apart),
        stride_(space.stride()) {}

  /// Appends all lines not traced yet that pass one of the corners.
  void trace(const std::vector<CellIndex>& corners, std::vector<TracedLine>& lines);
  /// The line that a link becomes; the corners it joins must be nodes.
  TracedLine link(const Link& link, std::int32_t rank);
  /// Makes the steps of a line count as not traced.
  void forget(const TracedLine& line);

 private:
  struct Steps {
    std::array<Divide, 4> list;
    std::array<std::int32_t, 4> way;
    std::size_t count = 0;
  };
  Steps steps(CellIndex corner, bool untraced_only) const;
  bool traced(Divide step) const;
  bool ends_at(CellIndex corner) const;
  CellIndex other_end(Divide step, CellIndex corner) const;
  CellIndex ring_start(CellIndex corner) const;
  void trace_from(CellIndex start, std::vector<TracedLine>& lines);
  void turn_round(TracedLine& line, std::vector<LinePoint>& points, Divide last) const;
  LinePoint centre(CellIndex cell, double distance) const;
  LinePoint point(Divide step) const;
  LinePoint node(CellIndex corner) const;
  OutlineEdge edge_towards(CellIndex cell, int side) const;
  std::array<OutlineEdge, 2> seen_from(Divide step) const;
  bool narrow(Divide step) const;
  double excess(CellIndex cell, OutlineEdge first, OutlineEdge second) const;

  FreeSpace& space_;
  const Outlines& outlines_;
  const EdgeGrid& edges_;
  Courses& courses_;
  double least_apart_;
  CellIndex stride_;
};

/// All dividing lines that pass the corners, in order. Cost: linear in the lines' length.
std::vector<TracedLine> trace_lines(LineTracer& tracer, const std::vector<CellIndex>& corners);

/// Which corners lines end at.
struct LineEnds {
  LineEnds() = default;
  explicit LineEnds(const std::vector<const TracedLine*>& lines);
  std::vector<CellIndex> corner;                               ///< by node, ascending
  std::vector<std::pair<std::int32_t, std::int32_t>> of_line;  ///< nodes it starts and ends at
};

/// Lines in order as a network; its nodes are in the order of their corners.
LineNetwork to_network(const std::vector<const TracedLine*>& lines, Courses& courses);
/// `ends` may have nodes that no line ends at.
LineNetwork to_network(const std::vector<const TracedLine*>& lines, const LineEnds& ends,
                       Courses& courses);

std::vector<const TracedLine*> list_of(const std::vector<TracedLine>& lines);

}  // namespace stope::topology
