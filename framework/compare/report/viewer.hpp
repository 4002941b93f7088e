#pragma once

#include <string>

#include "framework/compare/comparison.hpp"

namespace stope::report {

/// Pictures of two arms under a slider, and their lines over each other with what differs in
/// colour, for every recording and seed. Files are read from the comparison's folder; one that
/// cannot be read is said to be missing, and pictures past a total of 64 MiB are linked, not held.
/// Empty if the cells have neither pictures nor lines.
std::string viewer_html(const Comparison& comparison);

}  // namespace stope::report
