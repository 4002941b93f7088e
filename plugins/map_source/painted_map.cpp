#include "plugins/map_source/painted_map.hpp"

#include <fmt/format.h>

#include <cstring>

#include "plugins/map_source/cone_reading.hpp"
#include "plugins/map_source/raster_reader.hpp"
#include "stope/error.hpp"

namespace stope::map_source {
namespace {

template <class Cone>
PaintedMap read_with(const Cone& cone, RasterReader& raster, const ConicalYaml& map,
                     Context& context) {
  const RasterLayout& layout = raster.layout();
  PaintedMap painted;
  painted.grid.frame = {layout.width, layout.height, map.resolution, map.origin};
  painted.grid.cells.resize(painted.grid.frame.size());
  painted.hues.resize(painted.grid.frame.size());
  std::vector<std::uint8_t> row(layout.row_bytes());
  // Neighbours mostly have one colour: the last answer is kept.
  Rgb before{};
  ConePixel pixel = cone.read(before);
  for (std::int32_t y = 0; y < layout.height; ++y) {
    raster.read_row(row.data());
    std::uint8_t* cells =
        painted.grid.cells.data() + painted.grid.frame.place({0, layout.height - 1 - y});
    std::int16_t* hues = painted.hues.data() + painted.grid.frame.place({0, y});
    for (std::int32_t x = 0; x < layout.width; ++x) {
      Rgb colour{};
      std::memcpy(colour.data(), row.data() + 3 * static_cast<std::ptrdiff_t>(x), 3);
      if (colour != before) {
        pixel = cone.read(colour);
        before = colour;
      }
      if (!pixel.known) {
        throw Error(fmt::format(
            "the picture {} has a colour at column {}, row {} (from the top) that is none of this "
            "map's: red {}, green {}, blue {}. Was it edited, scaled or compressed, or is it "
            "another map's than {}?",
            map.image.string(), x, y, colour[0], colour[1], colour[2], map.file));
      }
      cells[x] = pixel.cell;
      hues[x] = pixel.hue;
    }
    if (y % 256 == 255) {
      context.stop_if_cancelled();
      context.progress(static_cast<double>(y + 1) / layout.height);
    }
  }
  return painted;
}

}  // namespace

PaintedMap read_painted_map(const ConicalYaml& map, Context& context) {
  const auto raster = open_raster(map.image);
  const RasterLayout& layout = raster->layout();
  if (layout.channels != 3 || layout.sample_bytes != 1 || layout.max_value != 255)
    throw Error(
        fmt::format("the picture {} of the conical map is no 8-bit colour picture: expected "
                    "a PPM (P6)",
                    map.image.string()));
  if (map.stope && (map.stope->width != layout.width || map.stope->height != layout.height)) {
    throw Error(fmt::format(
        "the conical map {} says {} x {} cells, but its picture {} has {} x {} pixels: they do not "
        "belong together",
        map.file, map.stope->width, map.stope->height, map.image.string(), layout.width,
        layout.height));
  }
  if (map.stope) return read_with(StopeCone(map.stope->floor, map.hue_step), *raster, map, context);
  return read_with(PaperCone(map.hue_start, map.hue_step, map.coefficient, map.rule), *raster, map,
                   context);
}

}  // namespace stope::map_source
