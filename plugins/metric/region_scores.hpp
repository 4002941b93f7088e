#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace stope::metric {

/// How well regions match true rooms. All of it is counted over the cells that are in a true room.
struct RegionScores {
  std::size_t rooms = 0, regions = 0;  ///< regions: those with a cell in a true room
  std::size_t cells = 0;               ///< in true rooms
  double recall = 0;     ///< mean over rooms: share of it in the region that overlaps it most
  double precision = 0;  ///< mean over regions: share of it in the room that overlaps it most
  /// Matthews correlation of "in the room" against "in its best region" over the cells: counts
  /// pooled over the rooms, and the mean of each room's own.
  double mcc = 0, mcc_mean = 0;
  /// Matthews correlation of "in the same room" against "in the same region" over all pairs.
  double mcc_pairs = 0;
};

/// Labels by cell; 0 and less is none. Cells without a true room are left out; a cell without a
/// region is in a region of its own. Throws Error if the lengths differ or there is no true room.
RegionScores score_regions(std::span<const std::int32_t> truth,
                           std::span<const std::int32_t> regions);

/// Matthews correlation coefficient; 0 where a margin is empty.
double matthews_correlation(double true_positive, double false_positive, double false_negative,
                            double true_negative);

}  // namespace stope::metric
