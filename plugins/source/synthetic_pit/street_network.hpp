#pragma once

#include <cstddef>
#include <vector>

#include "stope/geometry.hpp"

namespace stope::source {

/// A road designed as one curve, which may run through several junctions. Its drivable strip is all
/// that lies within half its width of the polyline.
struct Street {
  std::vector<Vector2> points;    ///< centre line, about kStreetStep apart
  std::vector<double> elevation;  ///< by point, metres
  std::vector<double> station;    ///< by point, metres from the first along the line
  double width = 0;               ///< metres, from berm to berm
  bool closed = false;            ///< the last point joins the first
  double half_width() const { return 0.5 * width; }
  double length() const;
  /// Direction of travel at a point, unit length.
  Vector2 direction(std::size_t point) const;
};

inline constexpr double kStreetStep = 2.0;

/// Where a street ends on another one (or starts there).
struct Attachment {
  std::size_t branch = 0;         ///< the street that ends
  bool at_end = false;            ///< its last point is the junction; else its first
  std::size_t through = 0;        ///< the street it meets
  std::size_t through_point = 0;  ///< at this point of its centre line, exactly
  Vector2 place = Vector2::Zero();
};

/// What a dead end is for.
enum class DeadEndKind { kLoadingFace, kDump, kYard };

/// The end of a street that meets no other: a round place to turn, centred on the street's end.
struct DeadEnd {
  std::size_t street = 0;
  bool at_end = true;  ///< of the street's last point; else of its first
  double radius = 0;   ///< metres, to the foot of the berm or face
  DeadEndKind kind = DeadEndKind::kLoadingFace;
};

/// The haul roads as designed: everything else (terrain, truth, route) follows from it.
struct StreetNetwork {
  std::vector<Street> streets;
  std::vector<Attachment> attachments;
  std::vector<DeadEnd> dead_ends;

  Vector2 centre(const DeadEnd& end) const;
  double elevation(const DeadEnd& end) const;
  /// Unit vector from the road into the turning place.
  Vector2 heading(const DeadEnd& end) const;
};

/// Makes a street of sampled points: fills stations; elevations are zero.
Street make_street(std::vector<Vector2> points, double width, bool closed);

}  // namespace stope::source
