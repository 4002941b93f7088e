#include <algorithm>
#include <cmath>
#include <vector>

#include "plugins/fusion/fuse.hpp"
#include "stope/stope.hpp"

namespace stope::fusion {
namespace {

/// The logarithm of a cell's odds, its probability kept off 0 and 1.
double log_odds(std::uint8_t cell, double certainty) {
  const double probability = std::clamp(cell / 254.0, 1 - certainty, certainty);
  return std::log(probability / (1 - probability));
}

}  // namespace

class Bayes final : public Map<OccupancyGrid(OccupancyGrid, OccupancyGrid)> {
 public:
  struct Params {
    double certainty = 0.98;
    double prior_weight = 1;
    double live_weight = 1;
  } params;

  static void describe(About<Bayes>& about) {
    about.summary("Joins a prior and a live grid as independent evidence: log-odds add up.")
        .from("Moravec and Elfes 1985; Thrun et al., Probabilistic Robotics, sec. 9.2")
        .notes(
            "What is not known is no evidence. Where the grids contradict each other with equal "
            "weights the cell ends at one half, which is not free: give the live grid more weight "
            "to believe it. The result has the prior grid's lattice.")
        .ports("prior", "live", "grid")
        .param("certainty", &Params::certainty, more_than(0.5) + less_than(1.0),
               "The most a single cell is believed: probabilities are kept within 1 less this and "
               "this.")
        .param("prior_weight", &Params::prior_weight, at_least(0.0),
               "What the prior grid's log-odds are multiplied with.")
        .param("live_weight", &Params::live_weight, at_least(0.0),
               "What the live grid's log-odds are multiplied with.");
  }

  OccupancyGrid apply(const OccupancyGrid& prior, const OccupancyGrid& live, Context&) const {
    const std::vector<double> before = evidence(params.prior_weight);
    const std::vector<double> now = evidence(params.live_weight);
    return fuse(
        prior, live, make_table([&](std::uint8_t a, std::uint8_t b) {
          if (a == OccupancyGrid::kUnknown && b == OccupancyGrid::kUnknown) return a;
          return static_cast<std::uint8_t>(std::lround(254 / (1 + std::exp(-before[a] - now[b]))));
        }));
  }

 private:
  /// The weighted log-odds of each value of a cell; none if unknown.
  std::vector<double> evidence(double weight) const {
    std::vector<double> values(256, 0);
    for (std::size_t cell = 0; cell < OccupancyGrid::kUnknown; ++cell)
      values[cell] = weight * log_odds(static_cast<std::uint8_t>(cell), params.certainty);
    return values;
  }
};

STOPE_STAGE(Bayes, "fusion/bayes")

}  // namespace stope::fusion
