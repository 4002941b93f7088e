#include "plugins/topology/regions/connected_runs.hpp"

#include <algorithm>

namespace stope::topology {

void ConnectedRuns::clear() {
  runs_.clear();
  below_ = row_ = 0;
}

void ConnectedRuns::start_row() {
  below_ = row_;
  row_ = runs_.size();
}

void ConnectedRuns::add(std::int32_t row, std::int32_t first, std::int32_t last) {
  const std::size_t own = runs_.size();
  runs_.push_back({row, first, last, own});
  // Runs of the row before that end before this one begins touch no later one.
  while (below_ < row_ && runs_[below_].last < first - 1) ++below_;
  for (std::size_t other = below_; other < row_ && runs_[other].first <= last + 1; ++other) {
    const std::size_t a = piece(other), b = piece(own);
    runs_[std::max(a, b)].joined = std::min(a, b);
  }
}

std::size_t ConnectedRuns::piece(std::size_t run) {
  while (runs_[run].joined != run) {
    runs_[run].joined = runs_[runs_[run].joined].joined;
    run = runs_[run].joined;
  }
  return run;
}

}  // namespace stope::topology
