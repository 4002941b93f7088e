// Problem: divide free space at the valleys of its clearance, on all threads, and again after a
// change without looking at all of it.
// Idea: each cell has one neighbour that is uphill from it, which only its neighbours decide; a
// cell without one is a peak. Following these steps ends at a peak, whose basin the cell is in: the
// watershed of the clearance by steepest ascent. Bands of rows follow them to where they leave the
// band; where those cells lead is found next, and then every cell's basin, all in one grid. After a
// change, the cells whose uphill step is another and all that lead to them are followed again.
// Cost: three looks at every cell.
#include "plugins/topology/regions/basins.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>

#include "plugins/topology/for_each_band.hpp"

namespace stope::topology {
namespace {

constexpr std::uint8_t kPeak = 8, kObstacleHere = 9;  // beside the eight steps
constexpr std::int32_t kBandRows = 64;
constexpr std::int32_t kUnknown = -1;

void find_uphill(const Ground& ground, CellIndex first, std::int32_t count, std::uint8_t* uphill) {
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

}  // namespace

/// In the basins' grid there is at first, by cell, where going uphill from it leaves its band, or
/// its peak (0 in obstacles); at a peak the negative number of its basin; at last the basin.
class Basins::Climb {
 public:
  Climb(const Ground& ground, Basins& basins, const Checkpoint& checkpoint)
      : ground_(ground),
        basins_(basins),
        checkpoint_(checkpoint),
        cells_(basins.cells_),
        width_(ground.width()),
        height_(ground.height()),
        bands_((height_ + kBandRows - 1) / kBandRows),
        peaks_(static_cast<std::size_t>(bands_)),
        at_sides_(2 * static_cast<std::size_t>(bands_) * static_cast<std::size_t>(width_)) {}

  void run() {
    for (const std::int32_t row : {-1, height_}) {
      std::fill_n(cells_.padded_row(row), ground_.stride(), 0);
      if (basins_.uphill_)
        std::fill_n(basins_.uphill_->padded_row(row), ground_.stride(), kObstacleHere);
    }
    for_each_band(bands_, checkpoint_, [&] {
      return [&, uphill = std::make_shared<std::vector<std::uint8_t>>(
                     static_cast<std::size_t>(width_))](std::int32_t band) {
        for_rows(band, [&](CellIndex first) { step(band, first, uphill->data()); });
        for_rows(band, [&](CellIndex first) { follow(band, first); });
      };
    });
    for (const auto& found : peaks_)
      for (const CellIndex peak : found) cells_[peak] = -basins_.new_number(peak);
    for_each_band(bands_, checkpoint_, [&] { return [&](std::int32_t band) { look_on(band); }; });
    for_each_band(bands_, checkpoint_, [&] {
      return
          [&](std::int32_t band) { for_rows(band, [&](CellIndex first) { name(band, first); }); };
    });
  }

 private:
  std::int32_t first_row(std::int32_t band) const { return band * kBandRows; }
  std::int32_t end_row(std::int32_t band) const { return std::min(height_, first_row(band + 1)); }
  CellIndex begin(std::int32_t band) const { return ground_.index(0, first_row(band)); }
  CellIndex end(std::int32_t band) const { return ground_.index(0, end_row(band)); }

  template <class Visit>
  void for_rows(std::int32_t band, Visit visit) const {
    for (std::int32_t row = first_row(band); row < end_row(band); ++row)
      visit(ground_.index(0, row));
  }

  void step(std::int32_t band, CellIndex first, std::uint8_t* uphill) {
    const auto steps = neighbour_steps(ground_.stride());
    cells_[first - 1] = cells_[first + width_] = 0;
    if (basins_.uphill_) {
      PaddedGrid<std::uint8_t>& kept = *basins_.uphill_;
      kept[first - 1] = kept[first + width_] = kObstacleHere;
      uphill = kept.data() + first;
    }
    find_uphill(ground_, first, width_, uphill);
    for (std::int32_t i = 0; i < width_; ++i) {
      const CellIndex cell = first + i;
      const std::uint8_t step = uphill[i];
      cells_[cell] = step < kPeak ? cell + steps[step] : step == kPeak ? cell : 0;
      if (step == kPeak) peaks_[static_cast<std::size_t>(band)].push_back(cell);
    }
  }

  void follow(std::int32_t band, CellIndex first) {
    const CellIndex low = begin(band), past = end(band);
    for (CellIndex cell = first; cell < first + width_; ++cell) {
      CellIndex at = cell;
      while (at >= low && at < past && cells_[at] != at) {
        const CellIndex next = cells_[at];
        if (next == 0) break;
        if (next >= low && next < past) cells_[at] = cells_[next];
        at = next;
      }
      if (cells_[cell] != 0) cells_[cell] = at;
    }
  }

  /// The basins of the cells of a band's first and last row, where ways from other bands arrive.
  void look_on(std::int32_t band) {
    for (const bool last : {false, true}) {
      const CellIndex first = ground_.index(0, last ? end_row(band) - 1 : first_row(band));
      std::int32_t* basin = at_side(band, last);
      for (std::int32_t i = 0; i < width_; ++i) {
        std::int32_t on = cells_[first + i];
        while (on > 0) on = cells_[on];
        basin[i] = -on;
      }
    }
  }

  void name(std::int32_t band, CellIndex first) {
    const CellIndex low = begin(band), past = end(band);
    CellIndex before = 0;  // most cells go on as the one before
    std::int32_t basin = 0;
    for (CellIndex cell = first; cell < first + width_; ++cell) {
      const std::int32_t on = cells_[cell];
      if (on < 0) {  // a peak
        cells_[cell] = -on;
        continue;
      }
      if (on != before) {
        before = on;
        if (on == 0) {
          basin = 0;
        } else if (on < low) {
          basin = at_side(band - 1, true)[ground_.column(on)];
        } else if (on >= past) {
          basin = at_side(band + 1, false)[ground_.column(on)];
        } else {
          basin = std::abs(cells_[on]);  // whether the peak has its name already or not
        }
      }
      cells_[cell] = basin;
    }
  }

  std::int32_t* at_side(std::int32_t band, bool last) {
    return at_sides_.data() + (2 * static_cast<std::size_t>(band) + (last ? 1U : 0U)) *
                                  static_cast<std::size_t>(width_);
  }

  const Ground& ground_;
  Basins& basins_;
  const Checkpoint& checkpoint_;
  PaddedGrid<std::int32_t>& cells_;
  std::int32_t width_, height_, bands_;
  std::vector<std::vector<CellIndex>> peaks_;  ///< by band
  std::vector<std::int32_t> at_sides_;         ///< basins of the bands' first and last rows
};

Basins::Basins(const Ground& ground, bool keep, const Checkpoint& checkpoint)
    : cells_(ground.width(), ground.height()), peaks_(1, 0) {
  if (keep) uphill_.emplace(ground.width(), ground.height());
  Climb(ground, *this, checkpoint).run();
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

void Basins::update(const Ground& ground, const ChangedSquares& differs, ChangedSquares& changed) {
  PaddedGrid<std::uint8_t>& kept = *uphill_;
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
  const TileSet geometry(ground.width(), ground.height());
  std::array<std::uint8_t, TileSet::kSide> now{};
  // A cell's step depends on its neighbours.
  const ChangedSquares near = differs.widened(1);
  for (const std::int32_t tile : near.tiles()) {
    geometry.for_each_row(tile, [&](CellIndex first, std::int32_t count) {
      const std::int32_t row = ground.row(first);
      if (row < 0 || row >= ground.height()) return;
      if (ground.column(first) < 0) ++first, --count;
      count = std::min(count, ground.width() - ground.column(first));
      find_uphill(ground, first, count, now.data());
      for (std::int32_t i = 0; i < count; ++i) {
        const std::uint8_t step = now[static_cast<std::size_t>(i)];
        std::uint8_t& before = kept[first + i];
        if (step == before) continue;
        if (before == kPeak) gone.push_back(cells_[first + i]);
        before = step;
        follow_again(first + i);
      }
    });
  }
  for (std::size_t i = 0; i < moved.size(); ++i)
    for (std::size_t k = 0; k < steps.size(); ++k)
      if (const CellIndex cell = moved[i].cell - steps[k]; kept[cell] == k) follow_again(cell);
  for (const Moved& at : moved) {
    if (kept[at.cell] == kPeak) cells_[at.cell] = new_number(at.cell);
    if (kept[at.cell] == kObstacleHere) cells_[at.cell] = 0;
  }
  for (const Moved& at : moved) {
    CellIndex cell = at.cell;
    while (cells_[cell] == kUnknown) cell += steps[kept[cell]];
    const std::int32_t basin = cells_[cell];
    for (cell = at.cell; cells_[cell] == kUnknown; cell += steps[kept[cell]]) cells_[cell] = basin;
  }
  for (const Moved& at : moved)
    if (cells_[at.cell] != at.before) changed.add(ground.column(at.cell), ground.row(at.cell));
  for (const std::int32_t number : gone) {
    peaks_[static_cast<std::size_t>(number)] = 0;
    unused_.push_back(number);
  }
}

}  // namespace stope::topology
