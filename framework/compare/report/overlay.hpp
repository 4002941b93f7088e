#pragma once

#include <string>
#include <vector>

#include "framework/compare/report/line_difference.hpp"

namespace stope::report {

/// The lines of one recording's arms on one sheet of 1000 units across.
struct Sheet {
  Extent extent;
  double tolerance = 0;  ///< metres within which lines count as one
  double width = 1000, height = 1000;
};

/// A sheet that holds all of `drawings`.
Sheet sheet_for(const std::vector<Lines>& drawings);

/// Paths of an SVG `d`, in units of the sheet.
struct Overlay {
  std::string common, only_first, only_second;
  double metres_common = 0, metres_first = 0, metres_second = 0;
};

Overlay overlay_of(const Lines& first, const Lines& second, const Sheet& sheet);

}  // namespace stope::report
