#include <algorithm>

#include "plugins/fusion/fuse.hpp"
#include "stope/stope.hpp"

namespace stope::fusion {

class Maximum final : public Map<OccupancyGrid(OccupancyGrid, OccupancyGrid)> {
 public:
  struct Params {
  } params;

  static void describe(About<Maximum>& about) {
    about.summary("Joins a prior and a live grid: the higher probability of an obstacle counts.")
        .from("Huang et al., Obstacles in Mining Area, sec. V")
        .notes(
            "What only one of them knows is taken from it. Cautious: an obstacle that has gone "
            "stays for as long as either grid holds it. The result has the prior grid's lattice.")
        .ports("prior", "live", "grid");
  }

  OccupancyGrid apply(const OccupancyGrid& prior, const OccupancyGrid& live, Context&) const {
    static const CellTable kTable = make_table([](std::uint8_t a, std::uint8_t b) {
      if (a == OccupancyGrid::kUnknown) return b;
      return b == OccupancyGrid::kUnknown ? a : std::max(a, b);
    });
    return fuse(prior, live, kTable);
  }
};

STOPE_STAGE(Maximum, "fusion/maximum")

}  // namespace stope::fusion
