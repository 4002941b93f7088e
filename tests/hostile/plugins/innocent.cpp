// A stage with nothing wrong: what surrounds it makes the plugin hostile.
#include <stope/payloads/measures.hpp>
#include <stope/stage_instance.hpp>

namespace stope::hostile {

class Innocent final : public Map<Measures(Measures)> {
 public:
  struct Params {
  } params;
  static void describe(About<Innocent>& about) {
    about.summary("Gives back what it gets.").ports("measures", "measures");
  }
  Measures apply(const Measures& measures, Context&) const { return measures; }
};
STOPE_STAGE(Innocent, "hostile/innocent")

}  // namespace stope::hostile
