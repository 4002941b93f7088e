// Problem: say of a polyline how steep and how bent it is where a truck feels it, whatever the
// spacing of its vertices. Idea: measure over stretches of a fixed length that slide along it;
// their extremes lie where a stretch starts, ends or has its middle at a vertex. Cost: n log n in
// the vertices.
#include "measure_road.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace stope {
namespace {

// A polyline by the way along it.
class Track {
 public:
  explicit Track(std::span<const RoadVertex> line) : line_(line), way_(line.size(), 0) {
    for (std::size_t i = 1; i < line.size(); ++i)
      way_[i] = way_[i - 1] + std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
  }
  const std::vector<double>& way() const { return way_; }
  double length() const { return way_.back(); }
  RoadVertex at(double way) const {
    const auto next = std::upper_bound(way_.begin(), way_.end(), way);
    if (next == way_.end()) return line_.back();
    if (next == way_.begin()) return line_.front();
    const auto i = static_cast<std::size_t>(next - way_.begin());
    const RoadVertex &a = line_[i - 1], &b = line_[i];
    const double share = (way - way_[i - 1]) / (way_[i] - way_[i - 1]);
    if (share == 0) return a;  // a neighbour's height may not be known
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.z + share * (b.z - a.z), 0};
  }

 private:
  std::span<const RoadVertex> line_;
  std::vector<double> way_;
};

// Heights run straight between vertices, so the steepest stretch starts or ends at one.
double steepest(const Track& track) {
  const double span = std::min(kRoadGradeLength, track.length());
  double result = std::numeric_limits<double>::quiet_NaN();
  if (!(span > 0)) return result;
  const auto look = [&](double from) {
    if (from < 0 || from + span > track.length() + 1e-9) return;
    const double grade = std::abs(track.at(from + span).z - track.at(from).z) / span;
    if (!(grade <= result)) result = std::isnan(grade) ? result : grade;
  };
  for (const double way : track.way()) {
    look(way);
    look(way - span);
  }
  return result;
}

// The circle through the middle and both ends of a stretch, at every vertex and in the middle of
// short pieces between two, where a stretch can hold the bends of both.
double tightest(const Track& track) {
  const double reach = std::min(kRoadCurvatureLength, track.length()) / 2;
  double result = 0;
  const auto look = [&](double middle) {
    if (middle < reach || middle > track.length() - reach) return;
    const RoadVertex a = track.at(middle - reach), b = track.at(middle),
                     c = track.at(middle + reach);
    const double ab = std::hypot(b.x - a.x, b.y - a.y), bc = std::hypot(c.x - b.x, c.y - b.y),
                 ac = std::hypot(c.x - a.x, c.y - a.y);
    const double twice_area = std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    // Turned back on itself the three fall together; the reach is then the only length there is.
    const double product = ab * bc * ac;
    const double curvature = product > 0 ? 2 * twice_area / product : 2 / reach;
    if (curvature > result) result = curvature;
  };
  if (!(reach > 0)) return 0;
  const auto& way = track.way();
  look(track.length() / 2);
  for (std::size_t i = 1; i < way.size(); ++i) {
    look(way[i]);
    if (way[i] - way[i - 1] < 2 * reach) look((way[i] + way[i - 1]) / 2);
  }
  return result;
}

}  // namespace

void measure_road(std::span<const RoadVertex> line, RoadEdge& edge) {
  edge.length = 0;
  edge.min_clearance = line.front().clearance;
  double area = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double step = std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
    edge.length += step;
    area += step * 0.5 * (line[i].clearance + line[i - 1].clearance);
    edge.min_clearance = std::min(edge.min_clearance, line[i].clearance);
  }
  edge.mean_clearance = edge.length > 0 ? area / edge.length : line.front().clearance;
  const Track track(line);
  edge.curvature = tightest(track);
  // Without heights what is known from elsewhere stays.
  const bool heights = std::any_of(line.begin(), line.end(),
                                   [](const RoadVertex& vertex) { return !std::isnan(vertex.z); });
  if (heights) edge.grade = steepest(track);
}

}  // namespace stope
