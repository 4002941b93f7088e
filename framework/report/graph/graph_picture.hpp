#pragma once

#include <string>

#include "framework/executor/run_record.hpp"
#include "framework/pipeline/plan.hpp"

namespace stope::report {

/// The pipeline as an <svg> element for a page that carries graph_style(). `record` may be null.
std::string graph_picture(const Plan& plan, const RunRecord* record);

/// The style rules of graph_picture(). Colours are CSS variables of the page, with a light page's
/// colours where there are none.
const char* graph_style();

}  // namespace stope::report
