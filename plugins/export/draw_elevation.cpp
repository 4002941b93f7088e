#include "plugins/export/draw_elevation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace stope::exports {
namespace {

constexpr Colour kUnknown{199, 203, 209}, kOutside{226, 229, 233};
constexpr std::array<Colour, 5> kHeights{Colour{78, 121, 96}, Colour{158, 176, 118},
                                         Colour{214, 196, 148}, Colour{184, 148, 116},
                                         Colour{244, 242, 238}};

Colour colour_of(double share) {
  const double at = std::clamp(share, 0.0, 1.0) * (kHeights.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), kHeights.size() - 2);
  Colour mixed{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double a = kHeights[low][i], b = kHeights[low + 1][i];
    mixed[i] =
        static_cast<std::uint8_t>(std::lround(a + (at - static_cast<double>(low)) * (b - a)));
  }
  return mixed;
}

/// Height at a map point; NaN off the grid.
double height_at(const ElevationGrid& grid, const Vector2& point) {
  const auto cell = grid.frame.cell_at(point.x(), point.y());
  return cell ? grid.cells[grid.frame.place(*cell)] : std::numeric_limits<double>::quiet_NaN();
}

/// Lambert's cosine for light from the north-west, 45 degrees high; 0.7 on level ground.
double light_on(double slope_east, double slope_north) {
  const double length = std::sqrt(1 + slope_east * slope_east + slope_north * slope_north);
  return std::max(0.0, (slope_east * 0.5 - slope_north * 0.5 + std::sqrt(0.5)) / length);
}

}  // namespace

Canvas draw_elevation(const ElevationGrid& grid, const MapView& view) {
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const float height : grid.cells) {
    if (!std::isfinite(height)) continue;
    lowest = std::min<double>(lowest, height);
    highest = std::max<double>(highest, height);
  }
  const double range = std::max(1e-9, highest - lowest);
  const double step = std::max(view.metres_per_pixel, grid.frame.resolution);
  Canvas canvas(view.width, view.height, kOutside);
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      const Vector2 point = view.to_map(x + 0.5, y + 0.5);
      if (!grid.frame.cell_at(point.x(), point.y())) continue;
      const double height = height_at(grid, point);
      if (!std::isfinite(height)) {
        canvas.set(x, y, kUnknown);
        continue;
      }
      const auto slope = [&](const Vector2& ahead) {
        const double rise = height_at(grid, point + ahead) - height_at(grid, point - ahead);
        return std::isfinite(rise) ? rise / (2 * step) : 0.0;
      };
      const double light = light_on(slope(Vector2(step, 0)), slope(Vector2(0, step)));
      Colour colour = colour_of((height - lowest) / range);
      for (auto& part : colour) {
        part = static_cast<std::uint8_t>(
            std::lround(std::min(255.0, part * (0.35 + 0.65 * light / std::sqrt(0.5)))));
      }
      canvas.set(x, y, colour);
    }
  }
  return canvas;
}

}  // namespace stope::exports
