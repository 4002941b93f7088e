#include <stope/stope.hpp>

#include "sector.hpp"

namespace acme {

/// Gives sectors of 10, 20, 30 … cells.
class Sectors final : public stope::Stage {
 public:
  struct Params {
    int count = 3;
  } params;
  stope::Out<Sector> sectors;

  static void describe(stope::About<Sectors>& about) {
    about.summary("Divides a mine into sectors.")
        .output("sectors", &Sectors::sectors, "The sectors, from north to south.")
        .param("count", &Params::count, stope::at_least(0), "How many.");
  }

  void run(stope::Context& context) override {
    for (int i = 1; i <= params.count; ++i) {
      context.stop_if_cancelled();
      const double y = -100.0 * i;
      sectors.put(i, {10 * i, "sector " + std::to_string(i), {0, y, 100, y, 100, y + 100}});
    }
  }
};
STOPE_STAGE(Sectors, "acme/sectors")

}  // namespace acme
