#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "plugins/topology/padded_grid.hpp"

namespace stope::topology {

/// Cells that follow each other in a row of a grid.
struct CellRun {
  CellIndex first = 0;
  std::int32_t count = 0;
  CellIndex end() const { return first + count; }
  bool operator==(const CellRun&) const = default;
};

inline std::size_t count_cells(const std::vector<CellRun>& runs) {
  std::size_t cells = 0;
  for (const CellRun& run : runs) cells += static_cast<std::size_t>(run.count);
  return cells;
}

}  // namespace stope::topology
