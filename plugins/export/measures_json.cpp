#include <fmt/format.h>

#include <string>

#include "plugins/export/text_bytes.hpp"
#include "stope/stope.hpp"

namespace stope::exports {

class MeasuresJson final : public Map<Artefact(Measures)> {
 public:
  struct Params {
  } params;

  static void describe(About<MeasuresJson>& about) {
    about.summary("Writes measures as JSON: a list of name, value, unit and note.")
        .notes("Values that are not finite become null.")
        .ports("measures", "artefact")
        .writes({"json"});
  }

  Artefact apply(const Measures& measures, Context&) const {
    const std::size_t count = measures.names.size();
    if (measures.values.size() != count)
      throw Error(
          fmt::format("the measures have {} names but {} values", count, measures.values.size()));
    const auto text_at = [](const std::vector<std::string>& texts, std::size_t i) {
      return json_text(i < texts.size() ? texts[i] : "");
    };
    std::string text = "{\n\"measures\": [";
    for (std::size_t i = 0; i < count; ++i) {
      text += fmt::format("{}\n{{\"name\": {}, \"value\": {}, \"unit\": {}, \"note\": {}}}",
                          i == 0 ? "" : ",", json_text(measures.names[i]),
                          json_number(measures.values[i]), text_at(measures.units, i),
                          text_at(measures.notes, i));
    }
    return {{{"json", bytes_of(text + "\n]\n}\n")}}};
  }
};

STOPE_STAGE(MeasuresJson, "export/measures_json")

}  // namespace stope::exports
