#include "plugins/topology/nearest_outline.hpp"

#include "plugins/topology/nearest_obstacles.hpp"
#include "plugins/topology/write_edges.hpp"

namespace stope::topology {

void find_nearest_outline(const FreeSpace& space, const Outlines& outlines, EdgeGrid& edges,
                          const Checkpoint& checkpoint) {
  checkpoint();
  const BandBorders borders(space);
  BandSweep sweep(space);
  for (std::int32_t band = 0; band < borders.bands(); ++band) {
    checkpoint();
    sweep.run(borders, band,
              [&](auto row, auto first, auto begin, auto end, auto column, auto site_row) {
                write_edges(outlines, edges, row, first, begin, end, column, site_row);
              });
  }
}

}  // namespace stope::topology
