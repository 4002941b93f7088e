#pragma once

#include <string_view>
#include <vector>

#include "plugins/source/recording/pcd_header.hpp"

namespace stope::source {

/// Fields of a PCD file as numbers: for each wanted field, one value a point. A 64-bit whole number
/// beyond 2^53 loses its last digits. Reads any bytes without harm: sizes are checked against the
/// file's before memory is taken. Throws Error, which says what is wrong but not in which file.
std::vector<std::vector<double>> read_pcd_columns(const PcdHeader& header, std::string_view bytes,
                                                  const std::vector<const PcdField*>& wanted);

}  // namespace stope::source
