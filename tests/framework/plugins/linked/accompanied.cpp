// A stage whose result hangs on a library that its plugin is linked with.
#include <stope/stope.hpp>

#include "tests/framework/plugins/linked/companion.hpp"

namespace stope::linked {

class Accompanied final : public Map<Measures(Measures)> {
 public:
  struct Params {
  } params;
  static void describe(About<Accompanied>& about) {
    about.summary("Names a measure by the build of a library.").ports("measures", "measures");
  }
  Measures apply(const Measures&, Context&) const {
    return {{companion::build()}, {1}, {""}, {""}};
  }
};
STOPE_STAGE(Accompanied, "linked/accompanied")

}  // namespace stope::linked
