// Problem: give the cells between grown regions to the nearest one, and again after a change.
// Idea: waves from all cells that regions have grown into, in the order of these cells. Whose a
// cell is depends on its own piece of what is left over only, and on the grown cells beside that;
// so after a change the pieces that touch it are done again, and no others.
// Cost: a look at every cell for where waves start, then linear in what is left over.
#include "plugins/topology/regions/absorb_rest.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace stope::topology {
namespace {

constexpr std::uint8_t kFound = 2;  // beside an open cell's 1

class Waves {
 public:
  Waves(const Ground& ground, GrownRegions& grown)
      : grown_(grown), steps_(neighbour_steps(ground.stride())) {}

  /// To be called for cells that have grown, in increasing order.
  void start_from(CellIndex cell) {
    for (const CellIndex step : steps_)
      if (wanted(cell + step)) next_.emplace_back(cell + step, grown_.names[cell]);
  }

  void run(std::int32_t reach, const Checkpoint& checkpoint) {
    std::vector<std::pair<CellIndex, std::int32_t>> front;
    for (std::int32_t step = 0; step < reach && !next_.empty(); ++step) {
      checkpoint();
      std::swap(front, next_);
      next_.clear();
      std::size_t kept = 0;
      for (const auto& [cell, region] : front) {
        if (!wanted(cell)) continue;
        grown_.names[cell] = region;
        front[kept++] = {cell, region};
      }
      for (std::size_t i = 0; i < kept; ++i) start_from(front[i].first);
    }
  }

 private:
  bool wanted(CellIndex cell) const { return grown_.open[cell] && grown_.names[cell] == 0; }

  GrownRegions& grown_;
  std::array<CellIndex, 8> steps_;
  std::vector<std::pair<CellIndex, std::int32_t>> next_;  ///< cell, region that takes it
};

/// What is left over around some squares: the whole pieces, 8-connected.
std::vector<CellIndex> pieces_at(const Ground& ground, PaddedGrid<std::uint8_t>& open,
                                 const ChangedSquares& squares) {
  std::vector<CellIndex> cells;
  const auto find = [&](CellIndex cell) {
    if (open[cell] != 1) return;
    open[cell] |= kFound;
    cells.push_back(cell);
  };
  squares.for_each([&](std::int32_t left, std::int32_t bottom) {
    const std::int32_t right = std::min(left + ChangedSquares::kSide, ground.width() - 1);
    const std::int32_t top = std::min(bottom + ChangedSquares::kSide, ground.height() - 1);
    left = std::max(left - 1, 0), bottom = std::max(bottom - 1, 0);
    for (std::int32_t row = bottom; row <= top; ++row)
      for (std::int32_t column = left; column <= right; ++column) find(ground.index(column, row));
  });
  const auto steps = neighbour_steps(ground.stride());
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (const CellIndex step : steps) find(cells[i] + step);
  for (const CellIndex cell : cells) open[cell] = 1;
  return cells;
}

}  // namespace

void absorb_rest(const Ground& ground, GrownRegions& grown, std::int32_t reach,
                 const Checkpoint& checkpoint) {
  Waves waves(ground, grown);
  const auto width = static_cast<std::size_t>(ground.width());
  const CellIndex stride = ground.stride();
  std::vector<std::uint8_t> open_around(width);
  for (std::int32_t row = 0; row < ground.height(); ++row) {
    if (row % kRowsBetweenCheckpoints == 0) checkpoint();
    const CellIndex first = ground.index(0, row);
    const std::uint8_t* open = grown.open.data() + first;
    // The margin is not open. For many cells at a time.
    for (std::size_t i = 0; i < width; ++i) {
      const std::uint8_t* at = open + i;
      open_around[i] =
          static_cast<std::uint8_t>(at[-stride - 1] | at[-stride] | at[-stride + 1] | at[-1] |
                                    at[1] | at[stride - 1] | at[stride] | at[stride + 1]);
    }
    for (std::size_t i = 0; i < width; ++i)
      if (const CellIndex cell = first + static_cast<CellIndex>(i);
          open_around[i] && !open[i] && ground.free(cell))
        waves.start_from(cell);
  }
  waves.run(reach, checkpoint);
}

void absorb_again(const Ground& ground, GrownRegions& grown, std::int32_t reach,
                  const ChangedSquares& changed, MovedCells& moved, const Checkpoint& checkpoint) {
  const std::vector<CellIndex> cells = pieces_at(ground, grown.open, changed);
  std::vector<std::int32_t> before;
  before.reserve(cells.size());
  for (const CellIndex cell : cells) before.push_back(std::exchange(grown.names[cell], 0));
  std::vector<CellIndex> beside;
  for (const CellIndex cell : cells)
    for (const CellIndex step : neighbour_steps(ground.stride()))
      if (const CellIndex there = cell + step; !grown.open[there] && ground.free(there))
        beside.push_back(there);
  std::sort(beside.begin(), beside.end());
  beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
  Waves waves(ground, grown);
  for (const CellIndex cell : beside) waves.start_from(cell);
  waves.run(reach, checkpoint);
  for (std::size_t i = 0; i < cells.size(); ++i)
    moved.note(ground, cells[i], before[i], grown.names[cells[i]]);
}

}  // namespace stope::topology
