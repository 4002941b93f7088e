#include <fmt/format.h>

#include "plugins/metric/check_graph.hpp"
#include "plugins/metric/measure_list.hpp"
#include "plugins/metric/place_recall.hpp"
#include "stope/stope.hpp"

namespace stope::metric {

class Junctions final : public Map<Measures(RoadGraph, RoadGraph)> {
 public:
  struct Params {
    double within = 8;
  } params;

  static void describe(About<Junctions>& about) {
    about.summary("Precision, recall and F1 of junctions.")
        .notes(
            "A junction is a node at which three or more roads end. True and found ones are "
            "matched one to one, as many as can be. Recall is 1 if the truth has none, precision "
            "1 if the graph has none. Distances are those of matched ones, and no number if none "
            "is.")
        .ports("roads", "truth", "measures")
        .param("within", &Params::within, "m", more_than(0.0),
               "How far a found junction may lie from the true one.");
  }

  Measures apply(const RoadGraph& roads, const RoadGraph& truth, Context& context) const {
    check_graph(roads, "roads");
    check_truth(truth);
    const auto three = [](std::size_t degree) { return degree >= 3; };
    const PlaceRecall result =
        recall_places(nodes_of_degree(truth, three), nodes_of_degree(roads, three), params.within);
    if (result.truth == 0)
      context.info("the true graph has no junction: the recall is 1 by convention");
    return MeasureList(fmt::format("nodes of degree 3 and more, matched one to one within {} m; {} "
                                   "true, {} found, {} matched",
                                   params.within, result.truth, result.found, result.matched))
        .add("junction_f1", result.f1())
        .add("junction_precision", result.precision())
        .add("junction_recall", result.recall())
        .add("junction_distance_mean", result.mean_distance, "m")
        .add("junction_distance_max", result.max_distance, "m")
        .take();
  }
};

STOPE_STAGE(Junctions, "metric/junctions")

}  // namespace stope::metric
