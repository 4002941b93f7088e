#include <fmt/format.h>

#include <filesystem>

#include "plugins/map_source/movingai_map.hpp"
#include "stope/stope.hpp"

namespace stope::map_source {

class Movingai final : public Stage {
 public:
  struct Params {
    std::filesystem::path map;
    double resolution = 1.0;
  } params;
  OutValue<OccupancyGrid> grid;

  static void describe(About<Movingai>& about) {
    about.summary("Reads a map of the MovingAI benchmarks.")
        .from("Sturtevant, Benchmarks for Grid-Based Pathfinding, 2012; type octile")
        .notes(
            "`.`, `G` and `S` are free, `@`, `O`, `T` and `W` occupied; no cell is unknown. The "
            "lower-left corner of the map is at (0, 0), the file's first row the highest.")
        .output("grid", &Movingai::grid, "The map.")
        .param("map", &Params::map, required() + existing(PathKind::kFile), "The .map file.")
        .param("resolution", &Params::resolution, "m", between(1e-3, 1e4),
               "How long a cell is taken to be: the file does not say.");
  }

  void run(Context& context) override {
    OccupancyGrid result = read_movingai_map(params.map, params.resolution);
    context.info(fmt::format("read {} x {} cells of {} m", result.frame.width, result.frame.height,
                             result.frame.resolution));
    grid.set(std::move(result));
  }
};

STOPE_STAGE(Movingai, "map_source/movingai")

}  // namespace stope::map_source
