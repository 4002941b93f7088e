#include <fmt/format.h>

#include "plugins/metric/check_graph.hpp"
#include "plugins/metric/measure_list.hpp"
#include "plugins/metric/place_recall.hpp"
#include "stope/stope.hpp"

namespace stope::metric {

class DeadEnds final : public Map<Measures(RoadGraph, RoadGraph)> {
 public:
  struct Params {
    double within = 8;
  } params;

  static void describe(About<DeadEnds>& about) {
    about.summary("Recall and precision of dead ends: loading faces, dumps, yards.")
        .notes(
            "A dead end is a node at which one road ends. True and found ones are matched one to "
            "one, as many as can be. Recall is 1 if the truth has none, precision 1 if the graph "
            "has none. Distances are those of matched ones, and no number if none is.")
        .ports("roads", "truth", "measures")
        .param("within", &Params::within, "m", more_than(0.0),
               "How far a found dead end may lie from the true one.");
  }

  Measures apply(const RoadGraph& roads, const RoadGraph& truth, Context& context) const {
    check_graph(roads, "roads");
    check_truth(truth);
    const auto one = [](std::size_t degree) { return degree == 1; };
    const PlaceRecall result =
        recall_places(nodes_of_degree(truth, one), nodes_of_degree(roads, one), params.within);
    if (result.truth == 0)
      context.info("the true graph has no dead end: the recall is 1 by convention");
    return MeasureList(fmt::format("nodes of degree 1, matched one to one within {} m; {} true, "
                                   "{} found, {} matched",
                                   params.within, result.truth, result.found, result.matched))
        .add("dead_end_recall", result.recall())
        .add("dead_end_precision", result.precision())
        .add("dead_end_distance_mean", result.mean_distance, "m")
        .add("dead_end_distance_max", result.max_distance, "m")
        .take();
  }
};

STOPE_STAGE(DeadEnds, "metric/dead_ends")

}  // namespace stope::metric
