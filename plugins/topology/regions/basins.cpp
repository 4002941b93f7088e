// Problem: divide free space at the valleys of its clearance, on all threads, and again after a
// change without looking at all of it.
// Idea: each cell has one neighbour that is uphill from it, which only its neighbours decide; a
// cell without one is a peak. Following these steps ends at a peak, whose basin the cell is in: the
// watershed of the clearance by steepest ascent. Bands of rows follow them to where they leave the
// band, then across bands. After a change, the cells whose uphill step is another and all that lead
// to them are followed again.
// Cost: three looks at every cell.
#include "plugins/topology/regions/basins.hpp"

#include <algorithm>
#include <array>

#include "plugins/topology/for_each_band.hpp"

namespace stope::topology {
namespace {

constexpr std::uint8_t kPeak = 8, kObstacleHere = 9;  // beside the eight steps
constexpr std::int32_t kBandRows = 64;
constexpr std::int32_t kUnknown = -1;

}  // namespace

void Basins::find_uphill(const Ground& ground, CellIndex first, std::int32_t count,
                         std::uint8_t* uphill) {
  const auto steps = neighbour_steps(ground.stride());
  const std::int32_t* squared = ground.squared_cells() + first;
  for (std::int32_t i = 0; i < count; ++i) {
    const std::int32_t own = squared[i];
    std::int32_t best = own, chosen = kPeak;
    for (std::int32_t k = 0; k < 8; ++k) {
      const CellIndex step = steps[static_cast<std::size_t>(k)];
      const std::int32_t there = squared[i + step];
      // Of equally clear cells the earlier one is uphill.
      const bool better = there > best || (there == best && chosen == kPeak && step < 0);
      best = better ? there : best;
      chosen = better ? k : chosen;
    }
    uphill[i] = own == 0 ? kObstacleHere : static_cast<std::uint8_t>(chosen);
  }
}

Basins::Basins(const Ground& ground, const Checkpoint& checkpoint)
    : uphill_(ground.width(), ground.height()),
      cells_(ground.width(), ground.height()),
      peaks_(1, 0) {
  const auto steps = neighbour_steps(ground.stride());
  const std::int32_t height = ground.height(), width = ground.width();
  const std::int32_t bands = (height + kBandRows - 1) / kBandRows;
  const auto for_rows = [&](std::int32_t band, auto&& visit) {
    for (std::int32_t row = band * kBandRows; row < std::min(height, (band + 1) * kBandRows); ++row)
      visit(ground.index(0, row));
  };
  // Where going uphill from a cell leaves its band, or the peak; obstacles 0.
  PaddedGrid<CellIndex> onward(width, height);
  onward[0] = 0;
  std::vector<std::vector<CellIndex>> peaks(static_cast<std::size_t>(bands));
  for (const std::int32_t row : {-1, height}) {
    std::fill_n(uphill_.padded_row(row), ground.stride(), kObstacleHere);
    std::fill_n(cells_.padded_row(row), ground.stride(), 0);
  }
  for_each_band(bands, checkpoint, [&] {
    return [&](std::int32_t band) {
      const CellIndex begin = ground.index(0, band * kBandRows);
      const CellIndex end = ground.index(0, std::min(height, (band + 1) * kBandRows));
      for_rows(band, [&](CellIndex first) {
        uphill_[first - 1] = uphill_[first + width] = kObstacleHere;
        cells_[first - 1] = cells_[first + width] = 0;
        find_uphill(ground, first, width, uphill_.data() + first);
        for (CellIndex cell = first; cell < first + width; ++cell) {
          const std::uint8_t step = uphill_[cell];
          onward[cell] = step < kPeak ? cell + steps[step] : step == kPeak ? cell : 0;
          if (step == kPeak) peaks[static_cast<std::size_t>(band)].push_back(cell);
        }
      });
      for_rows(band, [&](CellIndex first) {
        for (CellIndex cell = first; cell < first + width; ++cell) {
          CellIndex at = cell;
          while (at >= begin && at < end && onward[at] != at) {
            const CellIndex next = onward[at];
            if (next == 0) break;
            if (next >= begin && next < end) onward[at] = onward[next];
            at = next;
          }
          if (onward[cell] != 0) onward[cell] = at;
        }
      });
    };
  });
  for (const auto& found : peaks)
    for (const CellIndex peak : found) cells_[peak] = new_number(peak);
  for_each_band(bands, checkpoint, [&] {
    return [&](std::int32_t band) {
      for_rows(band, [&](CellIndex first) {
        CellIndex before = 0, peak = 0;  // most cells go on as the one before
        for (CellIndex cell = first; cell < first + width; ++cell) {
          const CellIndex next = onward[cell];
          if (next == cell) continue;  // a peak
          if (next != before) {
            before = peak = next;
            while (onward[peak] != peak) peak = onward[peak];
          }
          cells_[cell] = peak == 0 ? 0 : cells_[peak];
        }
      });
    };
  });
}

std::int32_t Basins::new_number(CellIndex peak) {
  if (unused_.empty()) {
    peaks_.push_back(peak);
    return static_cast<std::int32_t>(peaks_.size()) - 1;
  }
  const std::int32_t number = unused_.back();
  unused_.pop_back();
  peaks_[static_cast<std::size_t>(number)] = peak;
  return number;
}

void Basins::update(const Ground& ground, const TileSet& differs, TileSet& changed) {
  const auto steps = neighbour_steps(ground.stride());
  struct Moved {
    CellIndex cell;
    std::int32_t before;
  };
  std::vector<Moved> moved;
  std::vector<std::int32_t> gone;
  const auto follow_again = [&](CellIndex cell) {
    if (cells_[cell] == kUnknown) return;
    moved.push_back({cell, cells_[cell]});
    cells_[cell] = kUnknown;
  };
  // A cell's step depends on its neighbours, so tiles beside those that differ count too.
  TileSet near(ground.width(), ground.height());
  for (const std::int32_t tile : differs.list()) {
    differs.for_each_row(tile, [&](CellIndex first, std::int32_t count) {
      near.add(ground.column(first) - 1, ground.row(first) - 1, ground.column(first) + count,
               ground.row(first) + 1);
    });
  }
  std::array<std::uint8_t, TileSet::kSide> now{};
  for (const std::int32_t tile : near.list()) {
    near.for_each_row(tile, [&](CellIndex first, std::int32_t count) {
      const std::int32_t row = ground.row(first);
      if (row < 0 || row >= ground.height()) return;
      if (ground.column(first) < 0) ++first, --count;
      count = std::min(count, ground.width() - ground.column(first));
      find_uphill(ground, first, count, now.data());
      for (std::int32_t i = 0; i < count; ++i) {
        const std::uint8_t step = now[static_cast<std::size_t>(i)];
        std::uint8_t& before = uphill_[first + i];
        if (step == before) continue;
        if (before == kPeak) gone.push_back(cells_[first + i]);
        before = step;
        follow_again(first + i);
      }
    });
  }
  for (std::size_t i = 0; i < moved.size(); ++i)
    for (std::size_t k = 0; k < steps.size(); ++k)
      if (const CellIndex cell = moved[i].cell - steps[k]; uphill_[cell] == k) follow_again(cell);
  for (const Moved& at : moved) {
    if (uphill_[at.cell] == kPeak) cells_[at.cell] = new_number(at.cell);
    if (uphill_[at.cell] == kObstacleHere) cells_[at.cell] = 0;
  }
  for (const Moved& at : moved) {
    CellIndex cell = at.cell;
    while (cells_[cell] == kUnknown) cell += steps[uphill_[cell]];
    const std::int32_t basin = cells_[cell];
    for (cell = at.cell; cells_[cell] == kUnknown; cell += steps[uphill_[cell]])
      cells_[cell] = basin;
  }
  for (const Moved& at : moved)
    if (cells_[at.cell] != at.before) changed.add(changed.tile_of(at.cell));
  for (const std::int32_t number : gone) {
    peaks_[static_cast<std::size_t>(number)] = 0;
    unused_.push_back(number);
  }
}

}  // namespace stope::topology
