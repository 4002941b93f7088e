#include "plugins/metric/place_recall.hpp"

#include <algorithm>
#include <limits>

#include "plugins/metric/measure_list.hpp"
#include "plugins/metric/node_matching.hpp"

namespace stope::metric {
namespace {

double share(std::size_t part, std::size_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 1;
}

}  // namespace

double PlaceRecall::recall() const { return share(matched, truth); }
double PlaceRecall::precision() const { return share(matched, found); }
double PlaceRecall::f1() const { return harmonic_mean(precision(), recall()); }

std::vector<Vector2> nodes_of_degree(const RoadGraph& graph,
                                     const std::function<bool(std::size_t degree)>& accept) {
  std::vector<std::size_t> degree(graph.nodes.size());
  for (const RoadEdge& edge : graph.edges) {
    ++degree[edge.from];
    ++degree[edge.to];
  }
  std::vector<Vector2> places;
  for (std::size_t i = 0; i < degree.size(); ++i)
    if (accept(degree[i])) places.emplace_back(graph.nodes[i].x, graph.nodes[i].y);
  return places;
}

PlaceRecall recall_places(const std::vector<Vector2>& truth, const std::vector<Vector2>& found,
                          double within) {
  PlaceRecall result;
  result.truth = truth.size();
  result.found = found.size();
  for (const MatchedPair& pair : match_points(truth, found, within)) {
    ++result.matched;
    result.mean_distance += pair.distance;
    result.max_distance = std::max(result.max_distance, pair.distance);
  }
  // Not 0: a graph in which nothing was found would look as if all lay in its very place.
  if (result.matched == 0)
    result.mean_distance = result.max_distance = std::numeric_limits<double>::quiet_NaN();
  else
    result.mean_distance /= static_cast<double>(result.matched);
  return result;
}

}  // namespace stope::metric
