#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace stope::topology {

/// Runs of cells, row after row, and which of them hold together (8-connected).
class ConnectedRuns {
 public:
  struct Run {
    std::int32_t row = 0, first = 0, last = 0;
    std::size_t joined = 0;  ///< an earlier run it holds together with, or itself
  };

  void clear();
  /// The next row, all of whose runs are added before another.
  void start_row();
  void add(std::int32_t row, std::int32_t first, std::int32_t last);
  std::span<const Run> runs() const { return runs_; }
  /// The same for all runs that hold together, when all have been added.
  std::size_t piece(std::size_t run);

 private:
  std::vector<Run> runs_;
  std::size_t below_ = 0, row_ = 0;  ///< the first run of the row before, and of this one
};

}  // namespace stope::topology
