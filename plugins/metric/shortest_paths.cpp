#include <fmt/format.h>

#include <cmath>

#include "plugins/metric/check_graph.hpp"
#include "plugins/metric/measure_list.hpp"
#include "plugins/metric/path_similarity.hpp"
#include "stope/stope.hpp"

namespace stope::metric {

class ShortestPaths final : public Map<Measures(RoadGraph, RoadGraph)> {
 public:
  struct Params {
    std::int64_t pairs = 1000;
    double tolerance = 0.05;
    double snap = 4;
  } params;

  static void describe(About<ShortestPaths>& about) {
    about.summary("Share of random pairs of true nodes whose way is as long in the graph.")
        .from("Wegner, Montoya-Zegarra and Schindler 2013, A Higher-Order CRF Model for Roads")
        .notes(
            "Nodes are joined to the nearest place of the graph. Pairs unreachable in both graphs "
            "are left out; unreachable in one they are wrong. Pairs are drawn with replacement "
            "from the run's seed. Roads are driven both ways.")
        .ports("roads", "truth", "measures")
        .param("pairs", &Params::pairs, at_least(1), "How many pairs of nodes are drawn.")
        .param("tolerance", &Params::tolerance, at_least(0.0),
               "Relative difference up to which a way is as long.")
        .param("snap", &Params::snap, "m", at_least(0.0),
               "How far a true node may lie from the graph.");
  }

  Measures apply(const RoadGraph& roads, const RoadGraph& truth, Context& context) const {
    check_graph(roads, "roads");
    check_truth(truth);
    MeasuredGraph found(roads), real(truth);
    std::vector<RoadPlace> nodes;
    for (std::uint32_t node = 0; node < truth.nodes.size(); ++node)
      if (real.distances.has_road(node)) nodes.push_back(real.distances.place_of_node(node));
    if (nodes.size() < 2)
      throw Error(
          "the true graph has a single node, so there are no pairs of nodes to drive "
          "between: use metric/apls, which also takes places along roads");
    Random random = context.random();
    std::size_t counted = 0, right = 0, longer = 0, shorter = 0, missing = 0;
    for (std::int64_t k = 0; k < params.pairs; ++k) {
      if (k % 256 == 0) context.stop_if_cancelled();
      const std::size_t a = random.below(nodes.size());
      const std::size_t b = (a + 1 + random.below(nodes.size() - 1)) % nodes.size();
      const double length = real.distances.between(nodes[a], nodes[b]);
      const double other =
          way_in(found, real.lines.position(nodes[a]), real.lines.position(nodes[b]));
      if (std::isinf(length) && std::isinf(other)) continue;
      ++counted;
      if (std::isinf(length) || std::isinf(other)) {
        ++missing;
      } else if (std::abs(other - length) <= params.tolerance * length) {
        ++right;
      } else {
        ++(other > length ? longer : shorter);
      }
    }
    if (counted == 0)
      throw Error("no drawn pair of true nodes is connected: raise 'pairs' or look at the truth");
    const auto share = [&](std::size_t part) {
      return static_cast<double>(part) / static_cast<double>(counted);
    };
    return MeasureList(fmt::format("{} random pairs of true nodes, {} counted, within {} of the "
                                   "true length, snapped within {} m",
                                   params.pairs, counted, params.tolerance, params.snap))
        .add("shortest_paths_correct", share(right))
        .add("shortest_paths_too_long", share(longer))
        .add("shortest_paths_too_short", share(shorter))
        .add("shortest_paths_missing", share(missing))
        .take();
  }

 private:
  double way_in(MeasuredGraph& graph, const Vector2& a, const Vector2& b) const {
    const auto start = graph.lines.nearest(a, params.snap);
    const auto goal = graph.lines.nearest(b, params.snap);
    if (!start || !goal) return RoadDistances::kUnreachable;
    return graph.distances.between(start->place, goal->place);
  }
};

STOPE_STAGE(ShortestPaths, "metric/shortest_paths")

}  // namespace stope::metric
