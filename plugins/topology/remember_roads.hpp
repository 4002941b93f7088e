#pragma once

#include <optional>

#include "plugins/topology/road_updater.hpp"
#include "stope/context.hpp"

namespace stope::topology {

/// What an extractor keeps of earlier items of a stream: nothing, until a grid says what part of it
/// has changed. Such streams are worth the memory; single maps do not pay for it.
class RememberRoads {
 public:
  RoadGraph extract(const OccupancyGrid& grid, const ExtractionMethod& method,
                    const Context& context) {
    const Checkpoint checkpoint = [&] { context.stop_if_cancelled(); };
    if (!grid.changed && !updater_) return extract_roads(grid, method, checkpoint);
    if (!updater_ || updater_->method() != method) {
      updater_.emplace(method);
      last_.reset();
    }
    const bool known = grid.changed && last_ == grid.changed->since;
    last_.reset();
    RoadGraph roads = known ? updater_->update(grid,
                                               {grid.changed->column, grid.changed->row,
                                                grid.changed->width, grid.changed->height},
                                               checkpoint)
                            : updater_->full(grid, checkpoint);
    last_ = context.index();
    return roads;
  }

 private:
  std::optional<RoadUpdater> updater_;
  std::optional<std::uint64_t> last_;  ///< index of the item that the updater knows
};

}  // namespace stope::topology
