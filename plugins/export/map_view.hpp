#pragma once

#include "plugins/export/canvas.hpp"
#include "stope/payloads/grid_frame.hpp"

namespace stope::exports {

/// Which part of the map frame a picture shows: north up, one scale both ways.
struct MapView {
  double left = 0, top = 0;  ///< metres, map frame: the picture's upper left corner
  double metres_per_pixel = 1;
  int width = 1, height = 1;  ///< pixels

  Vector2 to_pixel(double x, double y) const {
    return {(x - left) / metres_per_pixel, (top - y) / metres_per_pixel};
  }
  Vector2 to_map(double column, double row) const {
    return {left + column * metres_per_pixel, top - row * metres_per_pixel};
  }
};

/// The view of a whole grid: a pixel is a whole number of cells when the grid is larger than
/// `max_size` pixels, and a cell a whole number of pixels when it is much smaller.
MapView view_of(const GridFrame& frame, int max_size);

/// Cells a pixel of the view takes, at least 1.
int cells_per_pixel(const MapView& view, const GridFrame& frame);

/// Draws a scale bar of a round length into the lower left corner.
void draw_scale_bar(Canvas& canvas, const MapView& view);

}  // namespace stope::exports
