#pragma once

#include <memory>

#include "plugins/topology/column_reach.hpp"
#include "plugins/topology/extraction_method.hpp"

namespace stope::topology {

/// Road graphs of a grid that changes in places: keeps all that was computed of the last grid, and
/// computes anew only what a change can reach. Its graphs are, bit for bit, those of the functions
/// of extract_roads.hpp. Keeps about 12 bytes a cell.
class RoadUpdater {
 public:
  explicit RoadUpdater(const ExtractionMethod& method);
  ~RoadUpdater();
  RoadUpdater(RoadUpdater&&) noexcept;
  RoadUpdater& operator=(RoadUpdater&&) noexcept;

  const ExtractionMethod& method() const { return method_; }

  /// Of any grid. Throws Error like the extraction without memory.
  RoadGraph full(const OccupancyGrid& grid, const Checkpoint& checkpoint = never_stop);

  /// Of a grid that differs from the last one only within the window (clipped to the grid). Without
  /// a last grid, or if its frame was another, all is computed. If the grid differs elsewhere, the
  /// graph is of something between both.
  RoadGraph update(const OccupancyGrid& grid, const CellWindow& window,
                   const Checkpoint& checkpoint = never_stop);

 private:
  struct State;
  RoadGraph finish(const Checkpoint& checkpoint);
  ExtractionMethod method_;
  std::unique_ptr<State> state_;
};

}  // namespace stope::topology
