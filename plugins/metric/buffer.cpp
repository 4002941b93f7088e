#include <fmt/format.h>

#include <algorithm>

#include "plugins/metric/check_graph.hpp"
#include "plugins/metric/length_within.hpp"
#include "plugins/metric/measure_list.hpp"
#include "stope/stope.hpp"

namespace stope::metric {

class Buffer final : public Map<Measures(RoadGraph, RoadGraph)> {
 public:
  struct Params {
    double buffer = 2;
  } params;

  static void describe(About<Buffer>& about) {
    about.summary("Completeness, correctness and quality: lengths within a buffer of each other.")
        .from("Heipke, Mayer, Wiedemann and Jamet 1997, Evaluation of Automatic Road Extraction")
        .notes(
            "Completeness is the share of the true length that has the graph within the buffer, "
            "correctness the share of the graph's length within the buffer of the truth, quality "
            "matched graph length / (graph length + missed true length). Lengths are exact, not "
            "sampled. A graph without roads has correctness 1 and quality 0.")
        .ports("roads", "truth", "measures")
        .param("buffer", &Params::buffer, "m", more_than(0.0),
               "How far a road may lie from the other graph and still count as the same.");
  }

  Measures apply(const RoadGraph& roads, const RoadGraph& truth, Context& context) const {
    check_graph(roads, "roads");
    check_truth(truth);
    const GraphLines found(roads), real(truth);
    // Sums in another order may differ in the last bits: no share is above 1.
    const double matched =
        std::min(length_within(found, real, params.buffer), found.total_length());
    const double matched_truth =
        std::min(length_within(real, found, params.buffer), real.total_length());
    if (found.total_length() == 0)
      context.info("the graph has no roads: its correctness is 1 by convention");
    const double missed = real.total_length() - matched_truth;
    return MeasureList(fmt::format("buffer {} m; {:.1f} m of roads, {:.1f} m of truth",
                                   params.buffer, found.total_length(), real.total_length()))
        .add("completeness", matched_truth / real.total_length())
        .add("correctness", found.total_length() > 0 ? matched / found.total_length() : 1)
        .add("quality", matched / (found.total_length() + missed))
        .take();
  }
};

STOPE_STAGE(Buffer, "metric/buffer")

}  // namespace stope::metric
