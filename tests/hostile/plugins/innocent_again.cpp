// Takes the id of another stage.
#include <stope/payloads/measures.hpp>
#include <stope/stage_instance.hpp>

namespace stope::hostile {

class InnocentAgain final : public Map<Measures(Measures)> {
 public:
  struct Params {
  } params;
  static void describe(About<InnocentAgain>& about) {
    about.summary("Gives back what it gets.").ports("measures", "measures");
  }
  Measures apply(const Measures& measures, Context&) const { return measures; }
};
STOPE_STAGE(InnocentAgain, "hostile/innocent")

}  // namespace stope::hostile
