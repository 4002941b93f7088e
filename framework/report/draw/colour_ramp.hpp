#pragma once

#include <cstdint>
#include <vector>

#include "framework/report/picture.hpp"

namespace stope::report {

/// Colours along a line, between which others are mixed.
struct ColourRamp {
  std::vector<Colour> stops;  ///< evenly spaced, at least two
  /// The colour at `fraction` of the way, which is clamped to [0, 1].
  Colour at(double fraction) const;
};

/// From deep to high ground: slate, moss, sand, clay, chalk.
const ColourRamp& height_ramp();
/// From near to far: pale to deep blue.
const ColourRamp& distance_ramp();
/// Height of points, bright on a dark ground as on a light one.
const ColourRamp& point_ramp();
/// A soft colour for a label; neighbours in number differ.
Colour label_colour(std::int64_t label);
/// The grey of an occupancy value: white where free, dark where occupied, pale where unknown.
Colour occupancy_colour(std::uint8_t value);

}  // namespace stope::report
