#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace stope::topology {

/// A cell seen from the cell a region grows from.
struct CellOffset {
  std::int16_t dx = 0, dy = 0;
  bool operator==(const CellOffset&) const = default;
};

/// The rings of the circular scan: ring r holds the cells whose distance rounds to r, by angle.
/// Together they are every cell once.
class RingTable {
 public:
  static constexpr std::int32_t kMostRings = 16000;  ///< what a CellOffset can hold

  std::span<const CellOffset> ring(std::int32_t radius);
  /// How many cells the rings 0 … radius have.
  std::size_t cells_within(std::int32_t radius);

 private:
  void reach(std::int32_t radius);
  std::vector<CellOffset> cells_;
  std::vector<std::size_t> begin_{0};  ///< by ring; the last is the end
};

}  // namespace stope::topology
