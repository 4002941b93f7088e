#include "plugins/topology/nearest_outline.hpp"

#include <memory>

#include "plugins/topology/for_each_band.hpp"
#include "plugins/topology/nearest_obstacles.hpp"
#include "plugins/topology/write_edges.hpp"

namespace stope::topology {

void find_nearest_outline(const FreeSpace& space, const Outlines& outlines, EdgeGrid& edges,
                          const Checkpoint& checkpoint) {
  const BandBorders borders(space, checkpoint);
  // Free cells are written, obstacle cells read: bands do not disturb each other.
  for_each_band(borders.bands(), checkpoint, [&] {
    return [&, sweep = std::make_shared<BandSweep>(space)](std::int32_t band) {
      sweep->run(borders, band,
                 [&](auto row, auto first, auto begin, auto end, auto column, auto site_row) {
                   write_edges(outlines, edges, row, first, begin, end, column, site_row);
                 });
    };
  });
}

}  // namespace stope::topology
