#include <fmt/format.h>

#include "plugins/metric/check_graph.hpp"
#include "plugins/metric/measure_list.hpp"
#include "plugins/metric/path_similarity.hpp"
#include "stope/stope.hpp"

namespace stope::metric {

class Apls final : public Map<Measures(RoadGraph, RoadGraph)> {
 public:
  struct Params {
    double spacing = 50;
    double snap = 4;
    double min_path = 0;
  } params;

  static void describe(About<Apls>& about) {
    about.summary("Average path length similarity: do routes have the same lengths in both graphs?")
        .from("van Etten, Lindenbaum and Bacastow 2018, SpaceNet, sec. 5; CosmiQ's implementation")
        .notes(
            "Control points are nodes and points that part each edge evenly. For each pair "
            "connected in one graph the relative difference of its way in the other is taken, at "
            "most 1, and 1 if there is none; the harmonic mean of both directions, 0 if one is "
            "not positive. Roads are driven both ways.")
        .ports("roads", "truth", "measures")
        .param("spacing", &Params::spacing, "m", more_than(0.0),
               "Greatest distance between control points along an edge.")
        .param("snap", &Params::snap, "m", at_least(0.0),
               "How far a control point may lie from the other graph.")
        .param("min_path", &Params::min_path, "m", at_least(0.0),
               "Pairs nearer to each other than this are left out (CosmiQ's code: 10 m).");
  }

  Measures apply(const RoadGraph& roads, const RoadGraph& truth, Context& context) const {
    check_graph(roads, "roads");
    check_truth(truth);
    MeasuredGraph found(roads), real(truth);
    const PathSimilarityRules rules{params.spacing, params.snap, params.min_path};
    const auto checkpoint = [&] { context.stop_if_cancelled(); };
    const PathSimilarity forth = path_similarity(real, found, rules, checkpoint);
    if (forth.pairs == 0)
      throw Error(
          fmt::format("the true graph has no two connected control points at least min_path ({} m) "
                      "apart: lower 'spacing' ({} m) or 'min_path'",
                      params.min_path, params.spacing));
    const PathSimilarity back = path_similarity(found, real, rules, checkpoint);
    if (back.pairs == 0)
      context.info("the graph has no two connected control points: its half is 0 by convention");
    return MeasureList(fmt::format("control points every {} m, snapped within {} m, ways of at "
                                   "least {} m; truth {} points, {} snapped, {} pairs, {} missing; "
                                   "roads {}, {}, {}, {}",
                                   params.spacing, params.snap, params.min_path,
                                   forth.control_points, forth.snapped, forth.pairs, forth.missing,
                                   back.control_points, back.snapped, back.pairs, back.missing))
        .add("apls", harmonic_mean(forth.score, back.score))
        .add("apls_truth_onto_roads", forth.score)
        .add("apls_roads_onto_truth", back.score)
        .take();
  }
};

STOPE_STAGE(Apls, "metric/apls")

}  // namespace stope::metric
