#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "plugins/metric/check_graph.hpp"
#include "plugins/metric/measure_list.hpp"
#include "plugins/metric/obstacle_edges.hpp"
#include "stope/stope.hpp"

namespace stope::metric {

class Clearance final : public Map<Measures(RoadGraph, OccupancyGrid)> {
 public:
  struct Params : FreeRule {
  } params;

  static void describe(About<Clearance>& about) {
    about.summary("Least distance to an obstacle along the graph, and whether the graph knows it.")
        .notes(
            "Exact, along all of each road's polyline, not only at its vertices; obstacles are "
            "whole square cells and all outside of the grid. 0 where a road enters an obstacle. "
            "Of a graph without roads the least is infinite.")
        .ports("roads", "grid", "measures");
    describe_free_rule(about);
  }

  Measures apply(const RoadGraph& roads, const OccupancyGrid& grid, Context& context) const {
    check_graph(roads, "roads");
    const FreeCells cells = free_cells(grid, params);
    const ObstacleEdges obstacles(cells);
    double least = std::numeric_limits<double>::infinity(), overstated = 0;
    Vector2 where = Vector2::Zero();
    for (const RoadEdge& edge : roads.edges) {
      context.stop_if_cancelled();
      double of_edge = std::numeric_limits<double>::infinity();
      const auto line = roads.polyline(edge);
      for (std::size_t i = 1; i < line.size(); ++i) {
        const double here = grid.frame.resolution *
                            obstacles.distance(grid.frame.to_grid(line[i - 1].x, line[i - 1].y),
                                               grid.frame.to_grid(line[i].x, line[i].y));
        of_edge = std::min(of_edge, here);
        if (here >= least) continue;
        least = here;
        where = 0.5 * (Vector2(line[i - 1].x, line[i - 1].y) + Vector2(line[i].x, line[i].y));
      }
      overstated = std::max(overstated, edge.min_clearance - of_edge);
    }
    if (roads.edges.empty())
      context.warn("the graph has no roads: its least clearance is infinite");
    else
      context.info(fmt::format("the least clearance, {:.2f} m, is near ({:.1f}, {:.1f})", least,
                               where.x(), where.y()));
    return MeasureList("along whole polylines, to square obstacle cells and the map's border")
        .add("clearance_min", least, "m")
        .add("clearance_overstated_max", overstated, "m")
        .take();
  }
};

STOPE_STAGE(Clearance, "metric/clearance")

}  // namespace stope::metric
