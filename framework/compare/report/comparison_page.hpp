#pragma once

#include <string>

#include "framework/compare/comparison.hpp"

namespace stope::report {

/// report.html of a comparison: one file that opens from disk and needs no network, with its
/// pictures, tables and scripts inside. Reads the pictures and lines of the cells from the
/// comparison's folder.
std::string comparison_page(const Comparison& comparison);

/// Writes report.html and the files it offers (downloads_of) into the comparison's folder, each
/// whole or not at all. Throws Error with a sentence if that fails.
void write_comparison_report(const Comparison& comparison);

}  // namespace stope::report
