#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "plugins/map_source/map_yaml.hpp"
#include "plugins/map_source/raster_reader.hpp"
#include "plugins/map_source/raster_to_grid.hpp"
#include "stope/stope.hpp"

namespace stope::map_source {

class MapServer final : public Stage {
 public:
  struct Params {
    std::filesystem::path map;
  } params;
  OutValue<OccupancyGrid> grid;

  static void describe(About<MapServer>& about) {
    about.summary("Reads a map_server map: a yaml file and its PNG or PGM picture.")
        .from("ROS map_server and nav2 map_io")
        .notes(
            "The modes trinary, scale and raw, negate, thresholds and an origin with yaw are read "
            "as nav2 reads them; the picture's path is relative to the yaml. Probabilities keep "
            "254 steps where nav2 rounds to percent.")
        .output("grid", &MapServer::grid, "The map.")
        .param("map", &Params::map, required() + existing(PathKind::kFile), "The map's yaml file.");
  }

  std::vector<std::filesystem::path> also_reads() const {
    return {read_map_yaml(params.map).image};
  }

  void run(Context& context) override {
    const MapYaml map = read_map_yaml(params.map);
    const auto raster = open_raster(map.image);
    OccupancyGrid result = raster_to_grid(*raster, map, context);
    const bool any_free = std::any_of(result.cells.begin(), result.cells.end(),
                                      [](std::uint8_t cell) { return cell < 127; });
    if (!any_free) {
      context.warn(
          fmt::format("no cell of the map {} is free: is 'negate' right, and are the "
                      "thresholds?",
                      params.map.string()));
    }
    context.info(fmt::format("read {} x {} cells of {} m", result.frame.width, result.frame.height,
                             result.frame.resolution));
    grid.set(std::move(result));
  }
};

STOPE_STAGE(MapServer, "map_source/map_server")

}  // namespace stope::map_source
