#include <stope/payloads/measures.hpp>
#include <stope/stage_instance.hpp>

namespace stope::hostile {

class ThrowingConstructor final : public Map<Measures(Measures)> {
 public:
  struct Params {
  } params;
  ThrowingConstructor() { throw Error("the licence server cannot be reached"); }
  static void describe(About<ThrowingConstructor>& about) {
    about.summary("Cannot be made.").ports("measures", "measures");
  }
  Measures apply(const Measures& measures, Context&) const { return measures; }
};
STOPE_STAGE(ThrowingConstructor, "hostile/throwing_constructor")

}  // namespace stope::hostile
