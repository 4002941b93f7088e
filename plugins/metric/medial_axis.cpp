#include "plugins/metric/medial_axis.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "plugins/metric/nearest_obstacle.hpp"

namespace stope::metric {
namespace {

Vector2 centre_of(Cell cell) { return {cell.column + 0.5, cell.row + 0.5}; }

class Axis {
 public:
  Axis(const FreeCells& cells, double min_angle, double min_clearance)
      : nearest_(cells),
        min_angle_(min_angle),
        min_clearance_(min_clearance / cells.frame.resolution) {}

  // The axis' point between two neighbouring free cells, in cells.
  std::optional<Vector2> between(Cell p, Cell q) const {
    const Cell seen_p = nearest_.of(p), seen_q = nearest_.of(q);
    if (seen_p == seen_q) return std::nullopt;
    const Vector2 from = centre_of(p), a = centre_of(seen_p), b = centre_of(seen_q);
    const Vector2 step = centre_of(q) - from;
    const double slope = 2 * step.dot(b - a);
    const double gap = (from - b).squaredNorm() - (from - a).squaredNorm();
    const double share = slope > 0 ? std::clamp(gap / slope, 0.0, 1.0) : 0.5;
    const Vector2 place = from + share * step;
    const Vector2 to_a = a - place, to_b = b - place;
    const double radius = std::min(to_a.norm(), to_b.norm());
    if (radius - 0.5 < min_clearance_) return std::nullopt;
    // Each direction is known to half a cell only.
    const double cosine = to_a.dot(to_b) / (to_a.norm() * to_b.norm());
    if (std::acos(std::clamp(cosine, -1.0, 1.0)) - 1 / radius < min_angle_) return std::nullopt;
    return place;
  }

 private:
  NearestObstacle nearest_;
  double min_angle_, min_clearance_;
};

}  // namespace

std::vector<Vector2> medial_axis(const FreeCells& cells, double min_angle, double min_clearance) {
  const Axis axis(cells, min_angle, min_clearance);
  std::vector<Vector2> points;
  for (std::int32_t row = 0; row < cells.frame.height; ++row) {
    for (std::int32_t column = 0; column < cells.frame.width; ++column) {
      if (!cells.at(column, row)) continue;
      for (const Cell next : {Cell{column + 1, row}, Cell{column, row + 1}}) {
        if (!cells.at(next.column, next.row)) continue;
        if (const auto place = axis.between({column, row}, next))
          points.push_back(cells.frame.to_map(place->x(), place->y()));
      }
    }
  }
  return points;
}

}  // namespace stope::metric
