#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "framework/report/draw/simplify.hpp"
#include "framework/report/draw/sketches.hpp"
#include "framework/report/quantity_text.hpp"

namespace stope::report {
namespace {

// One line from its start to its end, both marked.
void add_way(Sketch& sketch, const char* style, std::vector<Vector2> points) {
  const double tolerance = half_a_pixel(points);
  points = simplified(std::move(points), tolerance);
  if (points.empty()) return;
  sketch.marks.push_back({"start", points.front(), "start"});
  sketch.marks.push_back({"goal", points.back(), "end"});
  sketch.strokes.push_back({style, std::move(points), false, ""});
}

}  // namespace

Sketch sketch_of(const Path& path) {
  Sketch sketch;
  sketch.kind = "Path";
  std::vector<Vector2> points;
  double clearance = std::numeric_limits<double>::infinity();
  for (const PathPoint& point : path.points) {
    points.emplace_back(point.x, point.y);
    if (point.clearance < clearance) clearance = point.clearance;
  }
  sketch.caption = fmt::format("{}, {}", length_text(path.length),
                               count_text(path.points.size(), "point", "points"));
  if (!path.edges.empty())
    sketch.caption += fmt::format(" along {}", count_text(path.edges.size(), "road", "roads"));
  if (std::isfinite(clearance) && clearance > 0)
    sketch.caption += fmt::format(", nearest obstacle {} away", length_text(clearance));
  add_way(sketch, "path", std::move(points));
  sketch.legend = {{"path", "", "path"}, {"start", "", "start"}, {"goal", "", "goal"}};
  return sketch;
}

Sketch sketch_of(const Trajectory& trajectory) {
  Sketch sketch;
  sketch.kind = "Trajectory";
  std::vector<Vector2> points;
  double length = 0;
  for (const StampedPose& pose : trajectory.poses) {
    const Vector2 place(pose.T_map_lidar.translation.x(), pose.T_map_lidar.translation.y());
    if (!points.empty()) length += (place - points.back()).norm();
    points.push_back(place);
  }
  sketch.caption = fmt::format("{}, {}", count_text(trajectory.poses.size(), "pose", "poses"),
                               length_text(length));
  if (trajectory.poses.size() > 1)
    sketch.caption +=
        " in " + duration_text(trajectory.poses.back().stamp - trajectory.poses.front().stamp);
  add_way(sketch, "track", std::move(points));
  sketch.legend = {{"track", "", "track"}, {"start", "", "start"}, {"goal", "", "end"}};
  return sketch;
}

Sketch sketch_of(const PoseGraph& graph) {
  Sketch sketch;
  sketch.kind = "Pose graph";
  std::size_t loops = 0;
  std::vector<Vector2> track;
  const auto place_of = [&](std::uint64_t id) -> const PoseNode* {
    const auto found = std::lower_bound(
        graph.nodes.begin(), graph.nodes.end(), id,
        [](const PoseNode& node, std::uint64_t wanted) { return node.id < wanted; });
    return found != graph.nodes.end() && found->id == id ? &*found : nullptr;
  };
  for (const PoseConstraint& constraint : graph.constraints) {
    if (constraint.kind != PoseConstraint::Kind::kLoopClosure) continue;
    ++loops;
    const PoseNode *from = place_of(constraint.from), *to = place_of(constraint.to);
    if (!from || !to) continue;
    sketch.strokes.push_back(
        {"link",
         {from->T_map_node.translation.head<2>(), to->T_map_node.translation.head<2>()},
         false,
         ""});
  }
  for (const PoseNode& node : graph.nodes)
    track.emplace_back(node.T_map_node.translation.head<2>());
  sketch.caption = fmt::format("{}, {}, {}", count_text(graph.nodes.size(), "node", "nodes"),
                               count_text(graph.constraints.size(), "constraint", "constraints"),
                               count_text(loops, "loop closed", "loops closed"));
  add_way(sketch, "track", std::move(track));
  return sketch;
}

Sketch sketch_of(const LineSet& lines) {
  Sketch sketch;
  sketch.kind = "Lines";
  std::vector<Vector2> all;
  for (const Vector3& vertex : lines.vertices) all.emplace_back(vertex.x(), vertex.y());
  const double tolerance = half_a_pixel(all);
  double length = 0;
  for (std::size_t i = 0; i + 1 < lines.begin.size(); ++i) {
    const std::uint64_t begin = lines.begin[i], end = lines.begin[i + 1];
    if (begin >= end || end > all.size()) continue;
    std::vector<Vector2> line(all.begin() + static_cast<std::ptrdiff_t>(begin),
                              all.begin() + static_cast<std::ptrdiff_t>(end));
    for (std::size_t k = 1; k < line.size(); ++k) length += (line[k] - line[k - 1]).norm();
    const bool closed = i < lines.closed.size() && lines.closed[i] != 0;
    sketch.strokes.push_back({"line", simplified(std::move(line), tolerance), closed,
                              i < lines.kind.size() ? lines.kind[i] : ""});
  }
  sketch.caption = fmt::format("{}, {}", count_text(sketch.strokes.size(), "line", "lines"),
                               length_text(length));
  return sketch;
}

Sketch sketch_of(const Measures& measures) {
  Sketch sketch;
  sketch.kind = "Measures";
  sketch.caption = count_text(measures.names.size(), "figure", "figures");
  sketch.measures = measures;
  return sketch;
}

}  // namespace stope::report
