#include "plugins/planner/shortened_route.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "plugins/planner/path_sampling.hpp"
#include "plugins/planner/road_ground.hpp"
#include "plugins/planner/route_geometry.hpp"
#include "plugins/planner/shortcut.hpp"

namespace stope::planner {
namespace {

bool clear(const DrivableGrid& grid, const std::vector<RoadVertex>& line) {
  for (std::size_t i = 1; i < line.size(); ++i)
    if (!grid.line_free({line[i - 1].x, line[i - 1].y}, {line[i].x, line[i].y})) return false;
  return true;
}

}  // namespace

std::vector<RoadVertex> shortened_route(std::vector<RoadVertex> line, const RoadNetwork& network,
                                        const DrivableGrid& grid, const RoadChanges& changes,
                                        const Say& say) {
  // A road's line may cut through what no way over cells can, which is longer then.
  const GridFrame& frame = grid.frame();
  std::optional<std::vector<Vector2>> points;
  bool slow = false;
  for (const CellBox& box :
       {cells_within_reach(frame, line), CellBox{0, 0, frame.width, frame.height}}) {
    if (box.size() > kMostShortcutCells) {
      say(fmt::format(
          "{} million cells lie where a shorter way could lead, more than the {} million that are "
          "searched: the way follows the roads; a coarser grid allows shortcuts",
          box.size() / 1'000'000, kMostShortcutCells / 1'000'000));
      return line;
    }
    const RoadGround ground(grid, network, changes, box, line);
    slow = ground.slow();
    points = shortcut(grid, ground, box, line, network.rules().min_clearance);
    if (points) break;
  }
  if (!points) return line;
  std::vector<RoadVertex> pulled;
  std::size_t nearest = 0;
  for (const Vector2& point : *points) {
    const auto distance = [&](std::size_t i) {
      return std::hypot(line[i].x - point.x(), line[i].y - point.y());
    };
    for (std::size_t i = nearest + 1; i < line.size(); ++i)
      if (distance(i) < distance(nearest)) nearest = i;
    pulled.push_back(
        {point.x(), point.y(), line[nearest].z, grid.clearance(point, kFarthestClearance)});
  }
  // Over cells a way may be a little longer than by road; but a road's line may cut corners.
  const bool by_road = !slow && length_of(line) <= length_of(pulled) && clear(grid, line);
  return by_road ? line : pulled;
}

}  // namespace stope::planner
