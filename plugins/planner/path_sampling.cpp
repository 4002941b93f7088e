#include "plugins/planner/path_sampling.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stope::planner {
namespace {

/// A polyline by distance along it.
class Line {
 public:
  explicit Line(const std::vector<RoadVertex>& vertices) {
    for (const RoadVertex& vertex : vertices) {
      const double step = vertices_.empty() ? 0
                                            : std::hypot(vertex.x - vertices_.back().x,
                                                         vertex.y - vertices_.back().y);
      if (!vertices_.empty() && step == 0) continue;
      along_.push_back(vertices_.empty() ? 0 : along_.back() + step);
      vertices_.push_back(vertex);
    }
  }
  double length() const { return along_.empty() ? 0 : along_.back(); }
  RoadVertex at(double along) const {
    if (along <= 0 || vertices_.size() < 2) return vertices_.front();
    if (along >= length()) return vertices_.back();
    const auto i = static_cast<std::size_t>(std::upper_bound(along_.begin(), along_.end(), along) -
                                            along_.begin());
    const RoadVertex &a = vertices_[i - 1], &b = vertices_[i];
    const double f = (along - along_[i - 1]) / (along_[i] - along_[i - 1]);
    return {a.x + f * (b.x - a.x), a.y + f * (b.y - a.y), a.z + f * (b.z - a.z),
            a.clearance + f * (b.clearance - a.clearance)};
  }
  double heading(double from, double to) const {
    const RoadVertex a = at(from), b = at(to);
    return std::atan2(b.y - a.y, b.x - a.x);
  }

 private:
  std::vector<RoadVertex> vertices_;
  std::vector<double> along_;
};

double wrapped(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

}  // namespace

double length_of(const std::vector<RoadVertex>& line) { return Line(line).length(); }

std::vector<PathPoint> sample_path(const std::vector<RoadVertex>& vertices, double step,
                                   double smoothing) {
  if (vertices.empty()) return {};
  const Line line(vertices);
  const double length = line.length();
  const double count = std::max(1.0, std::ceil(length / step - 1e-9));
  std::vector<PathPoint> points;
  points.reserve(static_cast<std::size_t>(count) + 1);
  for (double i = 0; i <= count; ++i) {
    const double s = length * i / count;
    const RoadVertex here = line.at(s);
    const double before = std::max(0.0, s - smoothing), after = std::min(length, s + smoothing);
    PathPoint point;
    point.x = here.x, point.y = here.y, point.z = here.z, point.clearance = here.clearance;
    point.yaw = line.heading(before, after);
    if (before < s && s < after) {
      const double turn = wrapped(line.heading(s, after) - line.heading(before, s));
      point.curvature = turn / (0.5 * (after - before));
    }
    points.push_back(point);
  }
  return points;
}

}  // namespace stope::planner
