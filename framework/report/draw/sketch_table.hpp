#pragma once

#include <string_view>

#include "framework/report/sketch.hpp"

namespace stope::report {

/// The function that draws payloads of this type (`stope/OccupancyGrid@1`), or an empty one if the
/// report has no picture for it.
SketchFunction sketch_function(std::string_view type);

}  // namespace stope::report
