#include <algorithm>
#include <vector>

#include "plugins/export/canvas.hpp"
#include "plugins/export/draw_grid.hpp"
#include "plugins/export/map_view.hpp"
#include "stope/stope.hpp"

namespace stope::exports {
namespace {

using Lines = std::vector<std::vector<Vector2>>;

constexpr Colour kRoad{24, 100, 171}, kDeadEnd{240, 140, 0}, kRoute{224, 49, 49};
constexpr Colour kTrack{47, 158, 68}, kPaper{255, 255, 255}, kStart{47, 158, 68};

void draw_trajectory(Canvas& canvas, const MapView& view, const Trajectory& trajectory,
                     double width) {
  std::vector<Vector2> line;
  for (const StampedPose& pose : trajectory.poses) {
    const Vector3& at = pose.T_map_lidar.translation;
    const Vector2 pixel = view.to_pixel(at.x(), at.y());
    if (line.empty() || (pixel - line.back()).norm() > 0.5) line.push_back(pixel);
  }
  canvas.stroke({line}, width, kTrack, 0.8);
}

void draw_roads(Canvas& canvas, const MapView& view, const RoadGraph& roads, double width) {
  Lines lines;
  std::vector<int> degree(roads.nodes.size());
  for (const RoadEdge& edge : roads.edges) {
    std::vector<Vector2> line;
    for (const RoadVertex& vertex : roads.polyline(edge))
      line.push_back(view.to_pixel(vertex.x, vertex.y));
    lines.push_back(std::move(line));
    ++degree[edge.from];
    ++degree[edge.to];
  }
  canvas.stroke(lines, width, kRoad);
  for (std::size_t i = 0; i < roads.nodes.size(); ++i) {
    const Vector2 at = view.to_pixel(roads.nodes[i].x, roads.nodes[i].y);
    canvas.disc(at, 1.9 * width, kPaper);
    canvas.disc(at, 1.4 * width, degree[i] == 1 ? kDeadEnd : kRoad);
  }
}

void draw_path(Canvas& canvas, const MapView& view, const Path& path, double width) {
  if (path.points.empty()) return;
  std::vector<Vector2> line;
  for (const PathPoint& point : path.points) line.push_back(view.to_pixel(point.x, point.y));
  canvas.stroke({line}, 3 * width, kPaper, 0.7);
  canvas.stroke({line}, 1.8 * width, kRoute);
  const auto mark = [&](const Vector2& at, Colour colour) {
    canvas.disc(at, 4.2 * width, kPaper);
    canvas.disc(at, 3.2 * width, colour);
  };
  mark(line.front(), kStart);
  mark(line.back(), kRoute);
}

}  // namespace

class Png final : public Map<Artefact(OccupancyGrid, Optional<RoadGraph>, Optional<Path>,
                                      Optional<Trajectory>)> {
 public:
  struct Params {
    int max_size = 2000;
  } params;

  static void describe(About<Png>& about) {
    about.summary("Draws a map, and on it roads, a path and a trajectory, north up.")
        .notes(
            "Free ground is light, obstacles dark, unknown grey. Roads and junctions are blue, "
            "dead ends orange, the path red from its green start, the trajectory green.")
        .ports("grid", "roads", "path", "trajectory", "artefact")
        .writes({"png"})
        .param("max_size", &Params::max_size, between(64, 20000),
               "Greatest width and height in pixels; larger maps are scaled down.");
  }

  Artefact apply(const OccupancyGrid& grid, const Optional<RoadGraph>& roads,
                 const Optional<Path>& path, const Optional<Trajectory>& trajectory,
                 Context&) const {
    if (grid.cells.empty()) throw Error("the grid has no cells, so there is nothing to draw");
    const MapView view = view_of(grid.frame, params.max_size);
    Canvas canvas = draw_grid(grid, view);
    const double width = std::max(1.4, std::min(canvas.width(), canvas.height()) / 500.0);
    if (trajectory) draw_trajectory(canvas, view, *trajectory, 1.2 * width);
    if (roads) draw_roads(canvas, view, *roads, width);
    if (path) draw_path(canvas, view, *path, width);
    draw_scale_bar(canvas, view);
    return {{{"png", canvas.png()}}};
  }
};

STOPE_STAGE(Png, "export/png")

}  // namespace stope::exports
