// Problem: the paper wants points "higher than a threshold over the ground", but a pit has no one
// ground: it climbs ramps, steps up benches and hides under trucks.
// Idea: the lower quartile of each cell's points stands for what lies low in it. The ground of a
// cell is a low quantile of the low points within a few metres. On a plane, level or a ramp, that
// is the plane (less a share of radius times slope); on a berm, a truck or the foot of a wall the
// lower surroundings set it; on a bench's edge the bench does, not the bench below, which makes up
// the lesser part. Single false points deep in the ground do not matter to a quantile. Cost: O(n
// log n) to sort the points into cells, then a selection among the disc's cells for each cell that
// has points near.
#include "plugins/rasterizer/local_ground.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace stope::rasterizer {
namespace {

constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
constexpr std::size_t kFewest = 3;  // low points that a quantile is taken of

/// The height below which a quarter of each cell's points lie: the lowest of a few, but not the
/// lowest of many, since poses err and smear the ground. NaN where a cell has no points.
std::vector<float> low_points(const PointCloud& cloud, const GridFrame& frame) {
  std::vector<std::size_t> first(frame.size() + 1, 0);
  const auto place_of = [&](const Point3f& point) -> std::optional<std::size_t> {
    const auto cell = frame.cell_at(cloud.origin.x() + point.x, cloud.origin.y() + point.y);
    if (!cell || !std::isfinite(point.z)) return std::nullopt;
    return frame.place(*cell);
  };
  for (const Point3f& point : cloud.points) {
    if (const auto place = place_of(point)) ++first[*place + 1];
  }
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  std::vector<float> heights(first.back());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for (const Point3f& point : cloud.points) {
    if (const auto place = place_of(point)) heights[next[*place]++] = point.z;
  }
  std::vector<float> lows(frame.size(), kNothing);
  tbb::parallel_for(std::size_t{0}, lows.size(), [&](std::size_t i) {
    if (first[i] == first[i + 1]) return;
    const auto begin = heights.begin() + static_cast<std::ptrdiff_t>(first[i]);
    const auto end = heights.begin() + static_cast<std::ptrdiff_t>(first[i + 1]);
    const auto low = begin + (end - begin - 1) / 4;
    std::nth_element(begin, low, end);
    lows[i] = *low;
  });
  return lows;
}

std::vector<Cell> disc_offsets(double radius) {
  std::vector<Cell> offsets;
  const auto reach = static_cast<std::int32_t>(std::floor(radius));
  for (std::int32_t dy = -reach; dy <= reach; ++dy) {
    for (std::int32_t dx = -reach; dx <= reach; ++dx) {
      if (dx * dx + dy * dy <= radius * radius) offsets.push_back({dx, dy});
    }
  }
  return offsets;
}

}  // namespace

LocalGround local_ground(const PointCloud& cloud, const GridFrame& frame, const GroundRules& rules,
                         Context& context) {
  LocalGround ground;
  const double scale = frame.resolution / rules.cell;
  ground.frame = {static_cast<std::int32_t>(std::ceil(frame.width * scale)),
                  static_cast<std::int32_t>(std::ceil(frame.height * scale)), rules.cell,
                  frame.origin};
  const std::vector<float> lows = low_points(cloud, ground.frame);
  ground.height.assign(lows.size(), kNothing);
  const std::vector<Cell> offsets = disc_offsets(rules.radius / rules.cell);
  context.stop_if_cancelled();
  tbb::parallel_for(0, ground.frame.height, [&](std::int32_t row) {
    std::vector<float> around;
    for (std::int32_t column = 0; column < ground.frame.width; ++column) {
      around.clear();
      for (const Cell& offset : offsets) {
        const Cell near{column + offset.column, row + offset.row};
        if (!ground.frame.contains(near)) continue;
        const float low = lows[ground.frame.place(near)];
        if (!std::isnan(low)) around.push_back(low);
      }
      if (around.size() < kFewest) continue;
      const auto rank =
          static_cast<std::ptrdiff_t>(rules.quantile * static_cast<double>(around.size() - 1));
      std::nth_element(around.begin(), around.begin() + rank, around.end());
      ground.height[ground.frame.place({column, row})] = around[static_cast<std::size_t>(rank)];
    }
  });
  return ground;
}

}  // namespace stope::rasterizer
