#include <stope/payloads/measures.hpp>
#include <stope/stage_instance.hpp>

namespace stope::hostile {

class ThrowsInDescribe final : public Map<Measures(Measures)> {
 public:
  struct Params {
  } params;
  static void describe(About<ThrowsInDescribe>&) { throw Error("the moon is in the wrong phase"); }
  Measures apply(const Measures& measures, Context&) const { return measures; }
};
STOPE_STAGE(ThrowsInDescribe, "hostile/throws_in_describe")

}  // namespace stope::hostile
