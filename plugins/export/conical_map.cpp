#include <string>

#include "plugins/export/conical_files.hpp"
#include "stope/stope.hpp"

namespace stope::exports {

class ConicalMap final : public Map<Artefact(RegionMap, Optional<OccupancyGrid>)> {
 public:
  struct Params {
    std::string stem = "map";
    double floor = 0.35;
  } params;

  static void describe(About<ConicalMap>& about) {
    about.summary("Writes regions and occupancy as one colour picture (PPM) and a yaml.")
        .from("Wang et al., Topological Map Construction, 2019, sec. 3")
        .notes(
            "Hue tells regions apart, saturation is occupancy, grey cells have no region. Regions, "
            "labels and every value of the grid come back exactly (map_source/conical_map), for "
            "any number of regions: few hues are given so that touching regions differ, and the "
            "yaml says which piece of colour is which region. Without a grid, cells of regions "
            "are written as free and all others as unknown, and the yaml says so.")
        .ports("regions", "grid", "artefact")
        .writes({"ppm"})
        .param("stem", &Params::stem,
               "The files' name without its ending, as the yaml names the picture.")
        .param("floor", &Params::floor, between(0.0118, 0.5),
               "Saturation of free cells: at 0 their hue would be lost, and with it the region.");
  }

  Artefact apply(const RegionMap& regions, const Optional<OccupancyGrid>& grid,
                 Context& context) const {
    return conical_files(regions, grid ? &*grid : nullptr, {params.stem, params.floor}, context);
  }
};

STOPE_STAGE(ConicalMap, "export/conical_map")

}  // namespace stope::exports
