#include "framework/report/draw/sketch_table.hpp"

namespace stope::report {

SketchFunction sketch_function(std::string_view) { return {}; }

}  // namespace stope::report
