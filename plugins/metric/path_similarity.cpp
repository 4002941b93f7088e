#include "plugins/metric/path_similarity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "stope/error.hpp"

namespace stope::metric {
namespace {

constexpr double kMostPoints = 20000;  // 200 million pairs

std::vector<RoadPlace> control_points(const MeasuredGraph& graph, double spacing) {
  double count = static_cast<double>(graph.graph.nodes.size());
  for (std::uint32_t e = 0; e < graph.lines.edge_count(); ++e)
    count += std::floor(graph.lines.length(e) / spacing);
  if (count > kMostPoints)
    throw Error(fmt::format(
        "a graph with {} nodes and {:.0f} m of roads has about {:.0f} control points; more than "
        "{:.0f} take too long: raise 'spacing' ({} m) or measure a part of the map",
        graph.graph.nodes.size(), graph.lines.total_length(), count, kMostPoints, spacing));
  std::vector<RoadPlace> points;
  for (std::uint32_t node = 0; node < graph.graph.nodes.size(); ++node)
    if (graph.distances.has_road(node)) points.push_back(graph.distances.place_of_node(node));
  for (std::uint32_t e = 0; e < graph.lines.edge_count(); ++e) {
    const double length = graph.lines.length(e), parts = std::ceil(length / spacing);
    for (double k = 1; k < parts; ++k) points.push_back({e, k / parts * length});
  }
  return points;
}

}  // namespace

PathSimilarity path_similarity(MeasuredGraph& from, MeasuredGraph& onto,
                               const PathSimilarityRules& rules,
                               const std::function<void()>& checkpoint) {
  const std::vector<RoadPlace> points = control_points(from, rules.spacing);
  std::vector<std::optional<NearPlace>> snapped;
  PathSimilarity result;
  for (const RoadPlace& point : points) {
    snapped.push_back(onto.lines.nearest(from.lines.position(point), rules.snap));
    result.snapped += snapped.back() ? 1 : 0;
  }
  result.control_points = points.size();
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    checkpoint();
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      const double length = from.distances.between(points[i], points[j]);
      if (length == RoadDistances::kUnreachable || length <= 0 || length < rules.min_path) continue;
      ++result.pairs;
      const double other = snapped[i] && snapped[j]
                               ? onto.distances.between(snapped[i]->place, snapped[j]->place)
                               : RoadDistances::kUnreachable;
      if (other == RoadDistances::kUnreachable) ++result.missing;
      sum += std::min(1.0, std::abs(length - other) / length);
    }
  }
  if (result.pairs > 0) result.score = 1 - sum / static_cast<double>(result.pairs);
  return result;
}

}  // namespace stope::metric
