#include <stope/payloads/measures.hpp>
#include <stope/stage_instance.hpp>

namespace stope::hostile {

class ImpossibleDefault final : public Map<Measures(Measures)> {
 public:
  struct Params {
    double width = -1;
  } params;
  static void describe(About<ImpossibleDefault>& about) {
    about.summary("Has a default outside its limits.")
        .ports("measures", "measures")
        .param("width", &Params::width, "m", at_least(0), "How wide.");
  }
  Measures apply(const Measures& measures, Context&) const { return measures; }
};
STOPE_STAGE(ImpossibleDefault, "hostile/impossible_default")

}  // namespace stope::hostile
