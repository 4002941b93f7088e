#include <cstdlib>
#include <stope/payloads/measures.hpp>
#include <stope/stage_instance.hpp>

namespace stope::hostile {

class AbortsInDescribe final : public Map<Measures(Measures)> {
 public:
  struct Params {
  } params;
  static void describe(About<AbortsInDescribe>&) { std::abort(); }
  Measures apply(const Measures& measures, Context&) const { return measures; }
};
STOPE_STAGE(AbortsInDescribe, "hostile/aborts_in_describe")

}  // namespace stope::hostile
