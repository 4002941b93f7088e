// Built against an SDK whose measures looked otherwise.
#include <stope/stage_instance.hpp>

namespace stope::hostile {

struct OldMeasures {
  static constexpr std::string_view kType = "stope/Measures@1";
  double value = 0;
  static constexpr void fields(auto& s, auto&& visit) { visit("value", s.value); }
};

class OtherLayout final : public Map<OldMeasures(OldMeasures)> {
 public:
  struct Params {
  } params;
  static void describe(About<OtherLayout>& about) {
    about.summary("Gives back what it gets.").ports("measures", "measures");
  }
  OldMeasures apply(const OldMeasures& measures, Context&) const { return measures; }
};
STOPE_STAGE(OtherLayout, "hostile/other_layout")

}  // namespace stope::hostile
