#pragma once

#include <string_view>
#include <vector>

#include "stope/geometry.hpp"

namespace stope::report {

/// Polylines in the map frame, metres.
using Lines = std::vector<std::vector<Vector2>>;

/// The lines of a GeoJSON text, closed roads (GeometryCollection) too. What is there twice, as both
/// directions of a road, is there once; pieces that meet end to end are joined. Empty if the text
/// is no GeoJSON or has no lines.
Lines lines_of_geojson(std::string_view text);

/// The lower left and the upper right of all points; empty lines have low > high.
struct Extent {
  Vector2 low, high;
  Extent();
  void include(const Lines& lines);
  bool empty() const { return !(low.x() <= high.x()); }
  double diagonal() const { return empty() ? 0 : (high - low).norm(); }
};

/// What two drawings share and what only one of them has.
struct LineDifference {
  Lines common;  ///< as the first has it
  Lines only_first, only_second;
};

/// Parts of a line that are farther than `tolerance` (> 0, metres) from every line of the other
/// differ, found to half of it.
LineDifference line_difference(const Lines& first, const Lines& second, double tolerance);

/// Metres of line.
double length_of(const Lines& lines);

/// What looks like one line in a picture of that diagonal: a round length of about a 500th.
double drawing_tolerance(double diagonal);

}  // namespace stope::report
