#include <fmt/format.h>

#include "plugins/metric/check_graph.hpp"
#include "plugins/metric/measure_list.hpp"
#include "plugins/metric/space_pieces.hpp"
#include "stope/stope.hpp"

namespace stope::metric {
namespace {

double difference(std::size_t a, std::size_t b) {
  return static_cast<double>(a > b ? a - b : b - a);
}

}  // namespace

class Homotopy final : public Map<Measures(RoadGraph, OccupancyGrid)> {
 public:
  struct Params : FreeRule {
    double min_hole_area = 10;
    double min_piece_area = 0;
  } params;

  static void describe(About<Homotopy>& about) {
    about
        .summary(
            "Does the graph have as many pieces and cycles as free space has pieces and holes?")
        .from("Edelsbrunner and Harer 2010, Computational Topology, ch. IV: Betti numbers")
        .notes(
            "Free cells are 8-connected, obstacles 4-connected, all outside of the grid is one "
            "obstacle. A hole's area is what its outer outline encloses. A node without a road is "
            "a piece of the graph.")
        .ports("roads", "grid", "measures")
        .param("min_hole_area", &Params::min_hole_area, "m^2", at_least(0.0),
               "Holes of less are not counted, nor is what they enclose.")
        .param("min_piece_area", &Params::min_piece_area, "m^2", at_least(0.0),
               "Pieces of free space of less are not counted.");
    describe_free_rule(about);
  }

  Measures apply(const RoadGraph& roads, const OccupancyGrid& grid, Context&) const {
    check_graph(roads, "roads");
    const Betti graph = betti_of_graph(roads);
    const Betti space =
        betti_of_space(free_cells(grid, params), params.min_hole_area, params.min_piece_area);
    return MeasureList(fmt::format("free 8-connected, obstacles 4-connected, holes of at least {} "
                                   "m^2, pieces of at least {} m^2",
                                   params.min_hole_area, params.min_piece_area))
        .add("delta_beta0", difference(graph.pieces, space.pieces))
        .add("delta_beta1", difference(graph.holes, space.holes))
        .add("graph_beta0", static_cast<double>(graph.pieces))
        .add("graph_beta1", static_cast<double>(graph.holes))
        .add("free_beta0", static_cast<double>(space.pieces))
        .add("free_beta1", static_cast<double>(space.holes))
        .take();
  }
};

STOPE_STAGE(Homotopy, "metric/homotopy")

}  // namespace stope::metric
