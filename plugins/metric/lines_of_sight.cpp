// Problem: what can be seen from a point among square cells, without errors of rounding.
// Idea: light spreads row by row as cones between two rays. Each run of free cells in the next row
// cuts a cone where it enters and where it leaves the row; what is left goes on. Rays always pass
// through the point and a corner of a cell, so they are compared by products of whole numbers.
// Cost: the number of pieces of rows in view.
#include "plugins/metric/lines_of_sight.hpp"

#include <algorithm>

namespace stope::metric {
namespace {

constexpr std::int64_t kUnit = LatticePoint::kUnit;

// A direction from the point: `x` to the right on `height` rows' way up or down, height > 0.
struct Ray {
  std::int64_t x = 0, height = 1;
};

bool left_of(const Ray& a, const Ray& b) { return a.x * b.height < b.x * a.height; }
Ray rightmost(const Ray& a, const Ray& b) { return left_of(a, b) ? b : a; }
Ray leftmost(const Ray& a, const Ray& b) { return left_of(b, a) ? b : a; }

// What is seen above a point (side = 1) or below it (side = -1).
class Half {
 public:
  Half(const LatticeSpace& space, LatticePoint from, int side)
      : space_(space), from_(from), side_(side) {
    // The first line of the lattice beyond the point, and the row before it.
    const std::int64_t below = from.y / kUnit;
    first_line_ = side > 0 ? below + 1 : below - (from.y % kUnit == 0 ? 1 : 0);
    start_ = space.run_at(row_before(first_line_), from.x);
  }

  bool sees(LatticePoint to) const {
    const Ray ray{to.x - from_.x, side_ * (to.y - from_.y)};
    const FreeRun* run = start_;
    for (std::int64_t line = first_line_; run != nullptr; line += side_) {
      const std::int64_t height = height_of(line);
      const Ray end{ray.x, ray.height};
      if (ray.height <= height) return to.x >= run->begin * kUnit && to.x <= run->end * kUnit;
      if (left_of(end, at(run->begin, height)) || left_of(at(run->end, height), end)) return false;
      run = run_on_ray(line, ray);
    }
    return false;
  }

  // Adds the corners within the cone from `left` to `right`; each end only if it is bounded.
  void add_corners(bool left_bounded, bool right_bounded, std::vector<std::uint32_t>& seen) {
    if (start_ == nullptr) return;
    const std::int64_t height = height_of(first_line_);
    Ray left = at(start_->begin, height), right = at(start_->end, height);
    if (left_bounded) left = rightmost(left, {0, 1});
    if (right_bounded) right = leftmost(right, {0, 1});
    if (left_of(right, left)) return;
    std::vector<Cone> open{{first_line_, left, right}};
    while (!open.empty()) {
      const Cone cone = open.back();
      open.pop_back();
      report(cone, seen);
      spread(cone, open);
    }
  }

 private:
  // The part of a line that is seen.
  struct Cone {
    std::int64_t line;
    Ray left, right;
  };

  std::int64_t row_before(std::int64_t line) const { return side_ > 0 ? line - 1 : line; }
  std::int64_t row_after(std::int64_t line) const { return side_ > 0 ? line : line - 1; }
  std::int64_t height_of(std::int64_t line) const { return side_ * (line * kUnit - from_.y); }
  Ray at(std::int64_t column, std::int64_t height) const {
    return {column * kUnit - from_.x, height};
  }

  // The first run of the row after a line that does not end left of a ray where it crosses the
  // line.
  const FreeRun* first_run(std::int64_t line, const Ray& ray) const {
    const std::int64_t row = row_after(line), height = height_of(line);
    return std::lower_bound(
        space_.runs_begin(row), space_.runs_end(row), ray,
        [&](const FreeRun& run, const Ray& r) { return left_of(at(run.end, height), r); });
  }
  const FreeRun* run_on_ray(std::int64_t line, const Ray& ray) const {
    const FreeRun* run = first_run(line, ray);
    if (run == space_.runs_end(row_after(line))) return nullptr;
    return left_of(ray, at(run->begin, height_of(line))) ? nullptr : run;
  }

  void spread(const Cone& cone, std::vector<Cone>& open) const {
    const std::int64_t near = height_of(cone.line), far = near + kUnit;
    const FreeRun* end = space_.runs_end(row_after(cone.line));
    for (const FreeRun* run = first_run(cone.line, cone.left); run != end; ++run) {
      if (left_of(cone.right, at(run->begin, near))) break;
      const Ray left = rightmost(rightmost(cone.left, at(run->begin, near)), at(run->begin, far));
      const Ray right = leftmost(leftmost(cone.right, at(run->end, near)), at(run->end, far));
      if (!left_of(right, left)) open.push_back({cone.line + side_, left, right});
    }
  }

  void report(const Cone& cone, std::vector<std::uint32_t>& seen) const {
    const auto& corners = space_.corners();
    const std::int64_t height = height_of(cone.line);
    const auto begin = corners.begin() + space_.first_corner(cone.line);
    const auto end = corners.begin() + space_.first_corner(cone.line + 1);
    for (auto corner = std::lower_bound(begin, end, cone.left,
                                        [&](const TurningCorner&c, const Ray&ray) {
                                          return left_of(at(c.column, height), ray);
                                        });
         corner != end && !left_of(cone.right, at(corner->column, height)); ++corner)
      seen.push_back(static_cast<std::uint32_t>(corner - corners.begin()));
  }

  const LatticeSpace& space_;
  LatticePoint from_;
  int side_;
  std::int64_t first_line_;
  const FreeRun* start_;
};

// How far one sees along a line of the lattice, to the right (step = 1) or left (-1): the last
// column reached.
std::int64_t end_of_sight(const LatticeSpace& space, LatticePoint from, int step) {
  const std::int64_t line = from.y / kUnit;
  std::int64_t x = step > 0 ? from.x / kUnit : (from.x + kUnit - 1) / kUnit;
  for (;; x += step) {
    const std::int64_t column = step > 0 ? x : x - 1;
    if (!space.free(column, line) && !space.free(column, line - 1)) return x;
  }
}

void add_corners_beside(const LatticeSpace& space, LatticePoint from,
                        std::vector<std::uint32_t>& seen) {
  if (from.y % kUnit != 0) return;
  const std::int64_t line = from.y / kUnit;
  const std::int64_t left = end_of_sight(space, from, -1), right = end_of_sight(space, from, 1);
  for (std::uint32_t i = space.first_corner(line); i < space.first_corner(line + 1); ++i) {
    const std::int64_t column = space.corners()[i].column;
    if (column >= left && column <= right && column * kUnit != from.x) seen.push_back(i);
  }
}

// A way turns at a corner towards its obstacle, so it can come only from where it does not head
// into the obstacle's own quarter or out of it.
bool can_turn(const TurningCorner& corner, std::int64_t dx, std::int64_t dy) {
  const bool up = (dx > 0 && dy > 0) || (dx < 0 && dy < 0);
  const bool down = (dx > 0 && dy < 0) || (dx < 0 && dy > 0);
  return corner.rising ? !up : !down;
}

}  // namespace

bool sees(const LatticeSpace& space, LatticePoint from, LatticePoint to) {
  if (from.y != to.y) return Half(space, from, to.y > from.y ? 1 : -1).sees(to);
  if (from.y % kUnit == 0) {
    return to.x >= from.x ? to.x <= end_of_sight(space, from, 1) * kUnit
                          : to.x >= end_of_sight(space, from, -1) * kUnit;
  }
  const FreeRun* run = space.run_at(from.y / kUnit, from.x);
  return run != nullptr && to.x >= run->begin * kUnit && to.x <= run->end * kUnit;
}

std::vector<std::uint32_t> corners_seen(const LatticeSpace& space, LatticePoint from,
                                        const TurningCorner* turning_at) {
  std::vector<std::uint32_t> seen;
  // A way that turns at a corner with its obstacle up-right goes on to the upper left or the lower
  // right.
  const bool rising = turning_at != nullptr && turning_at->rising;
  const bool falling = turning_at != nullptr && !turning_at->rising;
  Half(space, from, 1).add_corners(falling, rising, seen);
  Half(space, from, -1).add_corners(rising, falling, seen);
  add_corners_beside(space, from, seen);
  std::erase_if(seen, [&](std::uint32_t i) {
    const TurningCorner& corner = space.corners()[i];
    return !can_turn(corner, corner.column * kUnit - from.x, corner.line * kUnit - from.y);
  });
  return seen;
}

}  // namespace stope::metric
