#include <fmt/format.h>

#include <algorithm>

#include "plugins/metric/check_graph.hpp"
#include "plugins/metric/graph_lines.hpp"
#include "plugins/metric/measure_list.hpp"
#include "plugins/metric/medial_axis.hpp"
#include "plugins/metric/percentile.hpp"
#include "stope/stope.hpp"

namespace stope::metric {

class MedialDistance final : public Map<Measures(RoadGraph, OccupancyGrid)> {
 public:
  struct Params : FreeRule {
    double min_angle = 1.75;
    double min_clearance = 2;
    double step = 0.5;
  } params;

  static void describe(About<MedialDistance>& about) {
    about.summary("Distances between the graph and the exact medial axis of free space.")
        .from("Foskey, Lin and Manocha 2003, Efficient Computation of a Simplified Medial Axis")
        .notes(
            "The axis is had from the exact nearest obstacle cells and kept where two of them are "
            "seen at min_angle or more, so that corners and dents have none. Hausdorff and p95 are "
            "the larger, the mean is the mean of both directions: from points along the graph to "
            "the axis, and from the axis to the graph. Infinite if the graph has no roads.")
        .ports("roads", "grid", "measures")
        .param("min_angle", &Params::min_angle, "rad", between(0.0, 3.2),
               "Least angle at which the axis sees its two obstacles: 90 deg in a corner, 120 at "
               "the middle of three equal roads, 180 between parallel walls.")
        .param("min_clearance", &Params::min_clearance, "m", at_least(0.0),
               "The axis is left out where free space is narrower than twice this.")
        .param("step", &Params::step, "m", at_least(0.01), "Distance of points along the graph.");
    describe_free_rule(about);
  }

  Measures apply(const RoadGraph& roads, const OccupancyGrid& grid, Context& context) const {
    check_graph(roads, "roads");
    const auto axis = medial_axis(free_cells(grid, params), params.min_angle, params.min_clearance);
    if (axis.empty())
      throw Error(
          fmt::format("free space has no medial axis seen at {} rad from {} m of clearance: "
                      "lower 'min_angle' or 'min_clearance'",
                      params.min_angle, params.min_clearance));
    context.stop_if_cancelled();
    const GraphLines lines(roads);
    if (lines.total_length() / params.step > kMostPoints)
      throw Error(fmt::format("{:.0f} m of roads have too many points every {} m: raise 'step'",
                              lines.total_length(), params.step));
    if (lines.total_length() == 0) context.warn("the graph has no roads: distances are infinite");
    std::vector<double> to_axis = distances_to_axis(lines, axis), to_graph;
    for (const Vector2& point : axis) {
      const auto near = lines.nearest(point);
      to_graph.push_back(near ? near->distance : std::numeric_limits<double>::infinity());
    }
    const double mean = 0.5 * (mean_of(to_axis) + mean_of(to_graph));
    const double axis95 = percentile(to_axis, 0.95), graph95 = percentile(to_graph, 0.95);
    const double axis100 = percentile(to_axis, 1), graph100 = percentile(to_graph, 1);
    return MeasureList(fmt::format("axis seen at {} rad or more, clearance of at least {} m, {} "
                                   "points; graph every {} m",
                                   params.min_angle, params.min_clearance, axis.size(),
                                   params.step))
        .add("medial_hausdorff", std::max(axis100, graph100), "m")
        .add("medial_p95", std::max(axis95, graph95), "m")
        .add("medial_mean", mean, "m")
        .add("graph_to_axis_p95", axis95, "m")
        .add("graph_to_axis_max", axis100, "m")
        .add("axis_to_graph_p95", graph95, "m")
        .add("axis_to_graph_max", graph100, "m")
        .take();
  }

 private:
  static constexpr double kMostPoints = 1e8;

  std::vector<double> distances_to_axis(const GraphLines& lines,
                                        const std::vector<Vector2>& axis) const {
    std::vector<Box> boxes;
    for (const Vector2& point : axis) boxes.push_back(box_of(point, point));
    const BoxTree tree(std::move(boxes));
    std::vector<double> distances;
    visit_samples(lines, params.step, [&](const Vector2& point, double) {
      const auto near = tree.nearest(box_of(point, point), std::numeric_limits<double>::infinity(),
                                     [&](std::uint32_t i) { return (axis[i] - point).norm(); });
      distances.push_back(near->distance);
    });
    return distances;
  }
};

STOPE_STAGE(MedialDistance, "metric/medial_distance")

}  // namespace stope::metric
