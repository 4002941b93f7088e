#include <fmt/format.h>

#include <filesystem>
#include <utility>
#include <vector>

#include "plugins/map_source/colour_pieces.hpp"
#include "plugins/map_source/conical_yaml.hpp"
#include "plugins/map_source/labelled_map.hpp"
#include "plugins/map_source/painted_map.hpp"
#include "stope/stope.hpp"

namespace stope::map_source {

class ConicalMap final : public Stage {
 public:
  struct Params {
    std::filesystem::path map;
  } params;
  OutValue<OccupancyGrid> grid;
  OutValue<RegionMap> regions;

  static void describe(About<ConicalMap>& about) {
    about.summary("Reads a conical map: regions and occupancy in one colour picture, and its yaml.")
        .from("Wang et al., Topological Map Construction, 2019, sec. 3.3")
        .notes(
            "What export/conical_map wrote comes back to the last bit. Maps by the paper's own "
            "formulas are read too: cells that are wholly free are white there, so their region is "
            "lost; a region is the piece of colour that holds its vertex's pixel.")
        .output("grid", &ConicalMap::grid, "Occupancy.")
        .output("regions", &ConicalMap::regions, "The regions, with their labels.")
        .param("map", &Params::map, required() + existing(PathKind::kFile), "The map's yaml file.");
  }

  std::vector<std::filesystem::path> also_reads() const {
    return {read_conical_yaml(params.map).image};
  }

  void run(Context& context) override {
    const ConicalYaml map = read_conical_yaml(params.map);
    PaintedMap painted = read_painted_map(map, context);
    const ColourPieces pieces =
        colour_pieces(painted.hues, painted.grid.frame.width, painted.grid.frame.height);
    std::vector<std::string> warnings;
    RegionMap result = map.stope ? written_regions(map, painted, pieces)
                                 : painted_regions(map, painted, pieces, warnings);
    for (const std::string& warning : warnings)
      context.warn(fmt::format("the conical map {}: {}", map.file, warning));
    if (map.stope && !map.stope->measured) {
      context.warn(
          fmt::format("the conical map {} was written without a grid: its regions are taken to be "
                      "free, and all "
                      "else is unknown",
                      map.file));
    }
    context.info(fmt::format("read {} regions on {} x {} cells of {} m", result.regions.size(),
                             painted.grid.frame.width, painted.grid.frame.height,
                             painted.grid.frame.resolution));
    grid.set(std::move(painted.grid));
    regions.set(std::move(result));
  }
};

STOPE_STAGE(ConicalMap, "map_source/conical_map")

}  // namespace stope::map_source
