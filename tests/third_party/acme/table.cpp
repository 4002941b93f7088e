#include <sstream>
#include <stope/stope.hpp>

namespace acme {

class Table final : public stope::Map<stope::Artefact(stope::Measures)> {
 public:
  struct Params {
    std::string separator = "\t";
  } params;

  static void describe(stope::About<Table>& about) {
    about.summary("Writes measures as a table, one a line.")
        .ports("measures", "table")
        .param("separator", &Params::separator, "What stands between name and value.")
        .writes({"acme"});
  }

  stope::Artefact apply(const stope::Measures& measures, stope::Context&) const {
    std::ostringstream text;
    for (std::size_t i = 0; i < measures.values.size(); ++i) {
      text << measures.names[i] << params.separator << measures.values[i] << '\n';
    }
    const std::string bytes = text.str();
    return {{{"acme", {bytes.begin(), bytes.end()}}}};
  }
};
STOPE_STAGE(Table, "acme/table")

}  // namespace acme
