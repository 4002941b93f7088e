#include "plugins/export/canvas.hpp"
#include "plugins/export/draw_elevation.hpp"
#include "plugins/export/map_view.hpp"
#include "stope/stope.hpp"

namespace stope::exports {

class ElevationPng final : public Map<Artefact(ElevationGrid)> {
 public:
  struct Params {
    int max_size = 2000;
  } params;

  static void describe(About<ElevationPng>& about) {
    about.summary("Draws the height of the ground as a shaded relief, north up.")
        .ports("elevation", "artefact")
        .writes({"png"})
        .param("max_size", &Params::max_size, between(64, 20000),
               "Greatest width and height in pixels; larger maps are scaled down.");
  }

  Artefact apply(const ElevationGrid& grid, Context&) const {
    if (grid.cells.empty()) throw Error("the grid has no cells, so there is nothing to draw");
    const MapView view = view_of(grid.frame, params.max_size);
    Canvas canvas = draw_elevation(grid, view);
    draw_scale_bar(canvas, view);
    return {{{"png", canvas.png()}}};
  }
};

STOPE_STAGE(ElevationPng, "export/elevation_png")

}  // namespace stope::exports
