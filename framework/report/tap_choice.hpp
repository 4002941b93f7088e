#pragma once

#include <vector>

#include "framework/pipeline/plan.hpp"
#include "framework/report/sketch.hpp"

namespace stope::report {

/// An output of a stage worth reading along at.
struct TapChoice {
  PlannedSource source;
  bool digest = false;  ///< an entry under `outputs:` is made of it
  SketchFunction draw;  ///< empty: not to be drawn
  bool needed = false;  ///< to be read even if nothing else asks for the port
};

/// Which outputs the report reads: those that are exported, and those it can draw. A port that
/// nobody else reads is left alone, because a stage skips the work for unwanted ports, unless the
/// stage would have no reader at all or the port gives measures, which exist to be reported.
std::vector<TapChoice> choose_taps(const Plan& plan);

}  // namespace stope::report
