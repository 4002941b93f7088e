#include <fmt/format.h>

#include <algorithm>

#include "plugins/metric/check_graph.hpp"
#include "plugins/metric/measure_list.hpp"
#include "plugins/metric/node_matching.hpp"
#include "plugins/metric/travel_samples.hpp"
#include "stope/stope.hpp"

namespace stope::metric {
namespace {
constexpr int kMostPoints = 1000000;  // that one seed may reach
}

class Topo final : public Map<Measures(RoadGraph, RoadGraph)> {
 public:
  struct Params {
    double reach = 150;
    double interval = 30;
    double within = 4;
  } params;

  static void describe(About<Topo>& about) {
    about.summary("TOPO: does what can be reached from a place lie where it should?")
        .from("Biagioni and Eriksson 2012, Inferring Road Maps from GPS Traces, sec. 6")
        .notes(
            "Seeds are all true nodes with a road. From each, points are dropped at multiples of "
            "the interval of travel, on the truth (holes) from the seed and on the graph (marbles) "
            "from its nearest place; they are matched one to one, as many as can be. If the graph "
            "is nowhere near the seed all its holes are missed. Roads far from all seeds are not "
            "seen. Counts are pooled.")
        .ports("roads", "truth", "measures")
        .param("reach", &Params::reach, "m", more_than(0.0), "How far to travel from a seed.")
        .param("interval", &Params::interval, "m", at_least(0.1), "Travel between two points.")
        .param("within", &Params::within, "m", at_least(0.0),
               "How far a marble may lie from its hole, and the graph from the seed.");
  }

  Measures apply(const RoadGraph& roads, const RoadGraph& truth, Context& context) const {
    check_graph(roads, "roads");
    check_truth(truth);
    const MeasuredGraph found(roads), real(truth);
    const double longest = std::max(found.lines.total_length(), real.lines.total_length());
    if (longest / params.interval > kMostPoints)
      throw Error(
          fmt::format("{:.0f} m of roads have more than {} points every {} m: raise 'interval'",
                      longest, kMostPoints, params.interval));
    std::size_t seeds = 0, unseen = 0, holes = 0, marbles = 0, matched = 0;
    for (std::uint32_t node = 0; node < truth.nodes.size(); ++node) {
      if (!real.distances.has_road(node)) continue;
      context.stop_if_cancelled();
      ++seeds;
      const RoadPlace seed = real.distances.place_of_node(node);
      const auto true_points = travel_samples(real, seed, params.interval, params.reach);
      holes += true_points.size();
      const auto start = found.lines.nearest(real.lines.position(seed), params.within);
      if (!start) {
        ++unseen;
        continue;
      }
      const auto points = travel_samples(found, start->place, params.interval, params.reach);
      marbles += points.size();
      matched += match_points(true_points, points, params.within).size();
    }
    if (holes == 0)
      throw Error(fmt::format(
          "no true road leads {} m from any node, so TOPO has nothing to count: lower 'interval'",
          params.interval));
    const auto share = [&](std::size_t whole) {
      return whole > 0 ? static_cast<double>(matched) / static_cast<double>(whole) : 0;
    };
    if (marbles == 0) context.info("the graph has no marbles: its precision is 0 by convention");
    return MeasureList(
               fmt::format(
                   "reach {} m, interval {} m, matched one to one within {} m; {} seeds, {} "
                   "of them without a road near, {} holes, {} marbles, {} matched",
                   params.reach, params.interval, params.within, seeds, unseen, holes, marbles,
                   matched))
        .add("topo_f1", harmonic_mean(share(marbles), share(holes)))
        .add("topo_precision", share(marbles))
        .add("topo_recall", share(holes))
        .take();
  }
};

STOPE_STAGE(Topo, "metric/topo")

}  // namespace stope::metric
