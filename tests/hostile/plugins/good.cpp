// The plugin that must load whatever stands beside it.
#include <stope/stope.hpp>

namespace stope::hostile {

class Good final : public Map<Measures(Measures)> {
 public:
  struct Params {
    double factor = 2.0;
  } params;
  static void describe(About<Good>& about) {
    about.summary("Multiplies measures.")
        .from("Nobody, Nowhere, sec. 1")
        .notes("Only for tests.")
        .ports("measures", "measures")
        .param("factor", &Params::factor, "m", at_least(0.0) + at_most(9.0), "By how much.");
  }
  Measures apply(const Measures& measures, Context&) const {
    Measures result = measures;
    for (double& value : result.values) value *= params.factor;
    return result;
  }
};
STOPE_STAGE(Good, "hostile/good")

}  // namespace stope::hostile
