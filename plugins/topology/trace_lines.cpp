#include "plugins/topology/trace_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace stope::topology {
namespace {

class LineTracer {
 public:
  LineTracer(FreeSpace& space, const Outlines& outlines, const EdgeGrid& edges)
      : space_(space), outlines_(outlines), edges_(edges), stride_(space.stride()) {}

  TracedLines run(const std::vector<CellIndex>& corners, const std::vector<Link>& links) {
    for (const CellIndex corner : corners) forget(corner);
    for (const Link& link : links) {
      space_[link.from] |= kEndsHere;
      space_[link.to] |= kEndsHere;
    }
    for (const CellIndex corner : corners)
      if (ends_at(corner)) add_node(corner);
    for (const CellIndex corner : corners)
      if (ends_at(corner)) trace_from(corner);
    // What is left are rings without a junction.
    for (const CellIndex corner : corners) {
      const auto steps = untraced(corner);
      if (steps.count == 0) continue;
      space_[corner] |= kEndsHere;
      add_node(corner);
      trace_from(corner);
    }
    for (const Link& link : links) add_link(link);
    return std::move(result_);
  }

 private:
  struct Steps {
    std::array<Divide, 4> list;
    std::size_t count = 0;
  };

  bool has(CellIndex cell, std::uint8_t bit) const { return space_[cell] & bit; }

  template <class Wanted>
  Steps steps(CellIndex corner, Wanted wanted) const {
    const std::array<Divide, 4> all{
        {{corner + stride_, false}, {corner + 1, true}, {corner, false}, {corner, true}}};
    Steps result;
    for (const Divide step : all) {
      const bool divided = has(step.cell, step.north ? kDividedNorth : kDividedEast);
      if (divided && wanted(step)) result.list[result.count++] = step;
    }
    return result;
  }
  Steps all(CellIndex corner) const {
    return steps(corner, [](Divide) { return true; });
  }
  Steps untraced(CellIndex corner) const {
    return steps(corner, [this](Divide step) {
      return !has(step.cell, step.north ? kTracedNorth : kTracedEast);
    });
  }
  bool ends_at(CellIndex corner) const { return has(corner, kEndsHere) || all(corner).count != 2; }
  CellIndex other_end(Divide step, CellIndex corner) const {
    const CellIndex lower = step.north ? step.cell - 1 : step.cell - stride_;
    return corner == lower ? step.cell : lower;
  }

  void forget(CellIndex corner) {
    space_[corner] &= static_cast<std::uint8_t>(~kEndsHere);
    for (const Divide step : untraced_or_not(corner)) {
      const int traced = step.north ? kTracedNorth : kTracedEast;
      space_[step.cell] &= static_cast<std::uint8_t>(~traced);
    }
  }
  std::array<Divide, 2> untraced_or_not(CellIndex corner) const {
    return {{{corner, false}, {corner, true}}};
  }

  LinePoint centre(CellIndex cell, double distance) const {
    return {edges_.column(cell) + 0.5, edges_.row(cell) + 0.5, distance};
  }

  /// The place between the centres of the two cells that is equally far from their obstacles.
  LinePoint point(Divide step) const {
    const CellIndex a = step.cell, b = a + (step.north ? stride_ : 1);
    // Beside an obstacle the free cell is the whole road.
    if (has(a, kObstacle)) return centre(b, 1.0);
    if (has(b, kObstacle)) return centre(a, 1.0);
    const double excess_at_a = excess(a, edges_[a], edges_[b]);
    const double excess_at_b = excess(b, edges_[a], edges_[b]);
    double part = 0.5;
    if (excess_at_b > excess_at_a)
      part = std::clamp(-excess_at_a / (excess_at_b - excess_at_a), 0.0, 1.0);
    LinePoint result = centre(a, 0);
    (step.north ? result.y : result.x) += part;
    const Outlines::Place place = outlines_.place[static_cast<std::size_t>(edges_[a])];
    result.distance = distance_between(result, {place.column + 0.5, place.row + 0.5, 0});
    return result;
  }
  /// How much further the first edge is than the second, squared; linear along a line.
  double excess(CellIndex cell, OutlineEdge first, OutlineEdge second) const {
    return static_cast<double>(squared_distance(edges_, outlines_, cell, first) -
                               squared_distance(edges_, outlines_, cell, second));
  }

  void add_node(CellIndex corner) {
    node_at_.emplace(corner, static_cast<std::int32_t>(result_.corner.size()));
    const Steps around = all(corner);
    LinePoint mean;
    for (std::size_t i = 0; i < around.count; ++i) {
      const LinePoint next = point(around.list[i]);
      mean.x += next.x / static_cast<double>(around.count);
      mean.y += next.y / static_cast<double>(around.count);
      mean.distance += next.distance / static_cast<double>(around.count);
    }
    const Divide step = around.list[0];
    const CellIndex cell =
        has(step.cell, kObstacle) ? step.cell + (step.north ? stride_ : 1) : step.cell;
    result_.network.nodes.push_back({mean, false});
    result_.corner.push_back(corner);
    result_.outline.push_back(outlines_.of_edge[static_cast<std::size_t>(edges_[cell])]);
  }

  void trace_from(CellIndex start) {
    const Steps starts = untraced(start);
    for (std::size_t i = 0; i < starts.count; ++i) {
      Divide step = starts.list[i];
      if (has(step.cell, step.north ? kTracedNorth : kTracedEast)) continue;  // a ring came back
      Line line;
      line.from = node_at_.at(start);
      line.points.push_back(result_.network.nodes[static_cast<std::size_t>(line.from)].point);
      CellIndex corner = start;
      while (true) {
        space_[step.cell] |= step.north ? kTracedNorth : kTracedEast;
        line.points.push_back(point(step));
        corner = other_end(step, corner);
        if (ends_at(corner)) break;
        step = untraced(corner).list[0];
      }
      line.to = node_at_.at(corner);
      line.points.push_back(result_.network.nodes[static_cast<std::size_t>(line.to)].point);
      result_.network.lines.push_back(std::move(line));
    }
  }

  void add_link(const Link& link) {
    Line line;
    line.from = node_at_.at(link.from);
    line.to = node_at_.at(link.to);
    line.points.push_back(result_.network.nodes[static_cast<std::size_t>(line.from)].point);
    for (const CellIndex cell : link.cells) {
      const std::int64_t squared = squared_distance(edges_, outlines_, cell, edges_[cell]);
      line.points.push_back(centre(cell, std::sqrt(static_cast<double>(squared))));
    }
    line.points.push_back(result_.network.nodes[static_cast<std::size_t>(line.to)].point);
    result_.network.lines.push_back(std::move(line));
  }

  FreeSpace& space_;
  const Outlines& outlines_;
  const EdgeGrid& edges_;
  CellIndex stride_;
  std::unordered_map<CellIndex, std::int32_t> node_at_;
  TracedLines result_;
};

}  // namespace

TracedLines trace_lines(FreeSpace& space, const Outlines& outlines, const EdgeGrid& edges,
                        const std::vector<CellIndex>& corners, const std::vector<Link>& links) {
  return LineTracer(space, outlines, edges).run(corners, links);
}

}  // namespace stope::topology
