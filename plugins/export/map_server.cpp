#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "plugins/export/text_bytes.hpp"
#include "stope/stope.hpp"

namespace stope::exports {
namespace {

// What a saved map says, and what map_server reads with the thresholds below. With nav2's own
// default of 0.25 an unknown 205 (occupied 0.196) would read as free.
constexpr double kOccupiedThreshold = 0.65, kFreeThreshold = 0.196;
constexpr std::uint8_t kOccupiedPixel = 0, kUnknownPixel = 205, kFreePixel = 254;

std::uint8_t pixel_of(std::uint8_t cell) {
  if (cell == OccupancyGrid::kUnknown) return kUnknownPixel;
  const double probability = cell / 254.0;
  if (probability > kOccupiedThreshold) return kOccupiedPixel;
  return probability < kFreeThreshold ? kFreePixel : kUnknownPixel;
}

}  // namespace

class MapServer final : public Map<Artefact(OccupancyGrid)> {
 public:
  struct Params {
    std::string stem = "map";
  } params;

  static void describe(About<MapServer>& about) {
    about.summary("Writes a grid as a map_server map: a yaml file and its PGM picture.")
        .from("nav2 map_saver, mode trinary")
        .notes(
            "Three values remain: occupied above 0.65, free below 0.196, unknown between and where "
            "nothing is known.")
        .ports("grid", "artefact")
        .writes({"yaml"})
        .param("stem", &Params::stem, "The files' name without its ending.");
  }

  Artefact apply(const OccupancyGrid& grid, Context&) const {
    const GridFrame& frame = grid.frame;
    const std::string yaml = fmt::format(
        "image: {}.pgm\nmode: trinary\nresolution: {}\norigin: [{}, {}, {}]\nnegate: 0\n"
        "occupied_thresh: {}\nfree_thresh: {}\n",
        params.stem, frame.resolution, frame.origin.x, frame.origin.y, frame.origin.yaw,
        kOccupiedThreshold, kFreeThreshold);
    ArtefactFile picture{"pgm",
                         bytes_of(fmt::format("P5\n{} {}\n255\n", frame.width, frame.height))};
    std::array<std::uint8_t, 256> pixels{};
    for (std::size_t cell = 0; cell < 256; ++cell)
      pixels[cell] = pixel_of(static_cast<std::uint8_t>(cell));
    const std::size_t header = picture.bytes.size();
    picture.bytes.resize(header + frame.size());
    for (std::int32_t row = 0; row < frame.height; ++row) {
      const std::uint8_t* cells = grid.cells.data() + frame.place({0, frame.height - 1 - row});
      std::transform(cells, cells + frame.width,
                     picture.bytes.data() + header + frame.place({0, row}),
                     [&](std::uint8_t cell) { return pixels[cell]; });
    }
    return {{{"yaml", bytes_of(yaml)}, std::move(picture)}};
  }
};

STOPE_STAGE(MapServer, "export/map_server")

}  // namespace stope::exports
