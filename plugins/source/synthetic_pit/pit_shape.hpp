#pragma once

#include <cstdint>
#include <vector>

#include "plugins/source/synthetic_pit/pit_parameters.hpp"
#include "stope/geometry.hpp"

namespace stope::source {

/// A heap with slopes at the angle of repose: a cone (top_radius 0) or a dump with a flat top.
struct Heap {
  Vector2 centre = Vector2::Zero();
  double top_radius = 0;
  double top = 0;   ///< elevation, metres
  double base = 0;  ///< an elevation that is under the ground all around
};

/// The ground before roads are cut into it: a gently rolling surface around elevation 0, a pit that
/// steps down by benches inside a crooked rim, and heaps. Map frame, metres; the map's centre is
/// (0, 0).
class PitShape {
 public:
  PitShape(const PitParameters& parameters, std::uint64_t seed);

  /// Distance of the rim from the pit's centre in a direction.
  double rim(double angle) const;
  /// The place `outward` metres outside the rim (negative: inside) in a direction.
  Vector2 at(double angle, double outward) const;
  /// How far inside the rim the benches have come down by `depth`, on average.
  double inward(double depth) const { return depth / bench_height_ * bench_run(); }
  double depth() const { return bench_height_ * static_cast<double>(benches_); }
  /// Whether the map shows only the bottom of a pit: too small for a ramp from the surface.
  bool yard() const { return yard_; }
  const Vector2& centre() const { return centre_; }
  /// The undisturbed surface around the pit.
  double surface(const Vector2& place) const;
  /// The ground with benches and heaps, smooth: no rubble.
  double ground(const Vector2& place) const;

  void add(const Heap& heap);

 private:
  double wall_run() const;
  double bench_run() const;
  double step_depth(double inside) const;

  std::uint64_t seed_;
  std::int64_t benches_;
  double bench_height_;
  double bench_width_;
  bool yard_;
  double radius_;
  Vector2 centre_;
  std::vector<double> rim_;  ///< by direction, the first again at the end
  /// Heaps by square of the map, so that a place looks at those nearby only.
  static constexpr double kSquare = 64;
  std::size_t square(double x, double y) const;
  std::int32_t squares_ = 0;  ///< along a side
  std::vector<std::vector<Heap>> heaps_;
};

}  // namespace stope::source
