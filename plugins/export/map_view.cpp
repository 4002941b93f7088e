#include "plugins/export/map_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace stope::exports {
namespace {

constexpr int kSmall = 800;  // pixels: smaller maps are enlarged
constexpr int kLargestCell = 8;

/// The greatest of 1, 2 and 5 times a power of ten that is at most `most`.
double round_length(double most) {
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= most) return factor * power;
  }
  return power;
}

std::string length_text(double metres) {
  return metres >= 1000 ? fmt::format("{} km", metres / 1000) : fmt::format("{} m", metres);
}

}  // namespace

MapView view_of(const GridFrame& frame, int max_size) {
  double left = 0, right = 0, bottom = 0, top = 0;
  for (int corner = 0; corner < 4; ++corner) {
    const Vector2 at =
        frame.to_map(corner % 2 == 0 ? 0 : frame.width, corner / 2 == 0 ? 0 : frame.height);
    left = corner == 0 ? at.x() : std::min(left, at.x());
    right = corner == 0 ? at.x() : std::max(right, at.x());
    bottom = corner == 0 ? at.y() : std::min(bottom, at.y());
    top = corner == 0 ? at.y() : std::max(top, at.y());
  }
  const double cells = std::max(right - left, top - bottom) / frame.resolution;
  MapView view;
  view.left = left;
  view.top = top;
  view.metres_per_pixel = frame.resolution;
  if (cells > max_size) {
    view.metres_per_pixel *= std::ceil(cells / max_size - 1e-9);
  } else if (cells > 0) {
    const double limit = std::min(kSmall, max_size) / cells;
    view.metres_per_pixel /= std::clamp(std::floor(limit), 1.0, static_cast<double>(kLargestCell));
  }
  const auto pixels = [&](double metres) {
    return std::max(1, static_cast<int>(std::ceil(metres / view.metres_per_pixel - 1e-6)));
  };
  view.width = pixels(right - left);
  view.height = pixels(top - bottom);
  return view;
}

int cells_per_pixel(const MapView& view, const GridFrame& frame) {
  return std::max(1, static_cast<int>(std::lround(view.metres_per_pixel / frame.resolution)));
}

void draw_scale_bar(Canvas& canvas, const MapView& view) {
  const double room = canvas.width() / 4.0;
  if (room < 40 || canvas.height() < 60) return;
  constexpr Colour kInk{40, 40, 40}, kPaper{255, 255, 255};
  const double metres = round_length(room * view.metres_per_pixel);
  const int length = static_cast<int>(std::lround(metres / view.metres_per_pixel));
  const int size = std::max(2, std::min(canvas.width(), canvas.height()) / 500);
  const int thickness = 2 * size, margin = 6 * size, height = 10 * size + thickness;
  const std::string label = length_text(metres);
  const int left = 2 * margin, bottom = canvas.height() - 2 * margin;
  const int wide = std::max(length, Canvas::text_width(size, label));
  canvas.box(left - margin, bottom - height - margin, left + wide + margin, bottom + margin, kPaper,
             0.8);
  canvas.text(left, bottom - height, size, label, kInk);
  canvas.box(left, bottom - thickness, left + length, bottom, kInk, 1);
}

}  // namespace stope::exports
