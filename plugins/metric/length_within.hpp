#pragma once

#include "plugins/metric/graph_lines.hpp"

namespace stope::metric {

/// Metres of the roads of `lines` that lie at most `buffer` metres from a road of `other`. Exact:
/// the parts of each straight piece that lie in the other's stadiums are joined, nothing is
/// sampled. O(pieces x pieces near each).
double length_within(const GraphLines& lines, const GraphLines& other, double buffer);

}  // namespace stope::metric
