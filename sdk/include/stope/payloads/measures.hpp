#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace stope {

/// Named figures. The arrays are of equal length.
struct Measures {
  static constexpr std::string_view kType = "stope/Measures@1";
  std::vector<std::string> names;  ///< such as `ate_rmse`
  std::vector<double> values;
  std::vector<std::string> units;  ///< SI, or empty for a plain number
  std::vector<std::string> notes;  ///< the parameters it was computed with
  static constexpr void fields(auto& s, auto&& visit) {
    visit("names", s.names);
    visit("values", s.values);
    visit("units", s.units);
    visit("notes", s.notes);
  }
};

}  // namespace stope
