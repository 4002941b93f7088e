// Points seen from above, coloured by height: each pixel shows its highest point. The extent is
// that of all points but the outermost hundredth, so that a stray return does not shrink the rest
// to a dot. One pass over the points (every n-th of more than four million).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "framework/report/draw/colour_ramp.hpp"
#include "framework/report/draw/sketches.hpp"
#include "framework/report/quantity_text.hpp"

namespace stope::report {
namespace {

constexpr std::size_t kPointsDrawn = 4'000'000, kPointsSampled = 50'000;
constexpr int kLongestPointSide = 1000, kTints = 200;

bool is_finite(const Point3f& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

struct Range {
  double low = 0, high = 0;
};

// The range of a coordinate without its outermost parts, a little widened.
Range range_of(std::vector<float> values, double outermost, double widen) {
  if (values.empty()) return {};
  const auto quantile = [&](double part) {
    const auto place =
        values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return static_cast<double>(*place);
  };
  const double low = quantile(outermost), high = quantile(1 - outermost);
  const double margin = std::max((high - low) * widen, 1e-3);
  return {low - margin, high + margin};
}

struct View {
  Range x, y, z;
  bool any = false;
};

View view_of(const std::vector<Point3f>& points) {
  std::vector<float> xs, ys, zs;
  const std::size_t step = std::max<std::size_t>(1, points.size() / kPointsSampled);
  for (std::size_t i = 0; i < points.size(); i += step) {
    if (!is_finite(points[i])) continue;
    xs.push_back(points[i].x);
    ys.push_back(points[i].y);
    zs.push_back(points[i].z);
  }
  return {range_of(xs, 0.005, 0.02), range_of(ys, 0.005, 0.02), range_of(zs, 0.02, 0.0),
          !xs.empty()};
}

// A pixel is at least so large that points fill a good part of the picture.
GridFrame frame_of(const View& view, std::size_t points) {
  const double width = view.x.high - view.x.low, height = view.y.high - view.y.low;
  const double fill = std::sqrt(width * height / (6.0 * static_cast<double>(points) + 1.0));
  GridFrame frame;
  frame.resolution = std::max({width / kLongestPointSide, height / kLongestPointSide, fill, 1e-4});
  frame.width = std::max(1, static_cast<int>(std::ceil(width / frame.resolution)));
  frame.height = std::max(1, static_cast<int>(std::ceil(height / frame.resolution)));
  frame.origin = {view.x.low, view.y.low, 0};
  return frame;
}

// Gives an empty pixel among many full ones their mean height: a dense surface should not look like
// sand, while single lines of a scan stay lines.
void fill_gaps(const GridFrame& frame, std::vector<float>& highest) {
  const std::vector<float> given = highest;
  for (std::int32_t row = 1; row + 1 < frame.height; ++row) {
    for (std::int32_t column = 1; column + 1 < frame.width; ++column) {
      const std::size_t place = frame.place({column, row});
      if (std::isfinite(given[place])) continue;
      float sum = 0;
      int count = 0;
      for (std::int32_t dy = -1; dy <= 1; ++dy) {
        for (std::int32_t dx = -1; dx <= 1; ++dx) {
          const float z = given[frame.place({column + dx, row + dy})];
          if (!std::isfinite(z)) continue;
          sum += z;
          ++count;
        }
      }
      if (count >= 4) highest[place] = sum / static_cast<float>(count);
    }
  }
}

Raster seen_from_above(const std::vector<Point3f>& points, const View& view) {
  const GridFrame frame = frame_of(view, points.size());
  std::vector<float> highest(frame.size(), -std::numeric_limits<float>::infinity());
  const std::size_t step = 1 + points.size() / kPointsDrawn;
  for (std::size_t i = 0; i < points.size(); i += step) {
    if (!is_finite(points[i])) continue;
    const auto cell = frame.cell_at(points[i].x, points[i].y);
    if (!cell) continue;
    float& pixel = highest[frame.place(*cell)];
    pixel = std::max(pixel, points[i].z);
  }
  fill_gaps(frame, highest);
  Picture picture{frame.width, frame.height, {}};
  picture.pixels.reserve(frame.size());
  const double range = std::max(view.z.high - view.z.low, 1e-6);
  for (int row = frame.height - 1; row >= 0; --row) {
    for (int column = 0; column < frame.width; ++column) {
      const float z = highest[frame.place({column, row})];
      const double tint = std::round((z - view.z.low) / range * kTints) / kTints;
      picture.pixels.push_back(std::isfinite(z) ? point_ramp().at(tint) : Colour{});
    }
  }
  return {frame, std::move(picture), false};
}

Sketch sketch_of_points(const char* kind, const std::vector<Point3f>& points,
                        const Vector3& origin) {
  Sketch sketch;
  sketch.kind = kind;
  sketch.points = true;
  sketch.caption = count_text(points.size(), "point", "points");
  const View view = view_of(points);
  if (!view.any) return sketch;
  sketch.raster = seen_from_above(points, view);
  sketch.raster->frame.origin.x += origin.x();
  sketch.raster->frame.origin.y += origin.y();
  sketch.caption +=
      fmt::format("; coloured by height, {} to {}", length_text(view.z.low + origin.z()),
                  length_text(view.z.high + origin.z()));
  return sketch;
}

}  // namespace

Sketch sketch_of(const PointCloud& cloud) {
  return sketch_of_points("Point cloud", cloud.points, cloud.origin);
}

Sketch sketch_of(const LidarScan& scan) {
  Sketch sketch = sketch_of_points("LiDAR scan", scan.points, Vector3(Vector3::Zero()));
  sketch.in_map = false;
  return sketch;
}

}  // namespace stope::report
