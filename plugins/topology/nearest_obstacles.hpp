// Problem: for each free cell, which obstacle cell is nearest, exactly.
// Idea: along a row the nearest obstacle cells are a lower envelope of parabolas (RowEnvelope). A
// run of free cells has an obstacle at both ends, which hides everything behind it, so each run is
// an envelope of its own. The cells to which an obstacle cell is nearest form a convex polygon with
// the obstacle cell inside: one that is nearest to nothing on a row is nearest to nothing on the
// rows beyond. So a row's envelope needs only what was left on the row before, plus the obstacles
// of that row: most columns are never looked at. A first sweep downwards keeps for each row the
// obstacle cells above it that can matter; a second one upwards joins them with those below.
// Rows are worked on in bands that depend on each other through each column's nearest obstacle
// beyond the band only, which one fast look at all cells finds.
// Cost: one look at all cells; then linear in the pieces of the envelopes, about a fifth of the
// free cells on maps, at worst all.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "plugins/topology/checkpoint.hpp"
#include "plugins/topology/free_runs.hpp"
#include "plugins/topology/row_envelope.hpp"

namespace stope::topology {

/// For bands of rows and each column, the rows of the nearest obstacles beyond the band.
class BandBorders {
 public:
  static constexpr std::int32_t kRows = 64;  ///< of a band

  explicit BandBorders(const FreeSpace& space, const Checkpoint& checkpoint = never_stop);
  std::int32_t bands() const { return bands_; }
  /// By column, from -1 on: the highest row below the band, or the lowest above, with an obstacle.
  const std::int32_t* below(std::int32_t band) const { return at(below_, band); }
  const std::int32_t* above(std::int32_t band) const { return at(above_, band); }

 private:
  const std::int32_t* at(const std::vector<std::int32_t>& rows, std::int32_t band) const {
    return rows.data() + static_cast<std::size_t>(band) * stride_;
  }
  std::size_t stride_;
  std::int32_t bands_;
  std::vector<std::int32_t> below_, above_;
};

/// The nearest obstacle cells of one band after the other, each by itself.
class BandSweep {
 public:
  explicit BandSweep(const FreeSpace& space)
      : space_(space),
        stride_(space.stride()),
        memory_(RowEnvelope::memory_for(space.stride())),
        below_(static_cast<std::size_t>(stride_)),
        left_(static_cast<std::size_t>(stride_)) {}

  /// Calls write(row, first, begin, end, column, site_row) for the free cells of columns from
  /// `begin` to before `end`, to which of all obstacle cells the one of `column` and `site_row` is
  /// nearest; of several that of the least column, and of two in a column the lower. Pieces of a
  /// run come from east to west; the run begins with column `first`.
  template <class Write>
  void run(const BandBorders& borders, std::int32_t band, Write write) {
    const std::int32_t bottom = band * BandBorders::kRows;
    const std::int32_t top = std::min(bottom + BandBorders::kRows, space_.height());
    sweep_down(bottom, top, borders.above(band));
    sweep_up(bottom, top, borders.below(band), write);
  }

 private:
  struct Site {
    std::int32_t column = 0, row = 0;
  };
  static constexpr Site kNoSite{INT32_MAX, 0};

  const std::uint8_t* bits(std::int32_t row) const { return space_.padded_row(row) + 1; }

  /// All columns that are free beside the band, as sites.
  void start(const std::uint8_t* beside, const std::int32_t* rows, Site* sites) const {
    for (std::int32_t column = 0; column < space_.width(); ++column) {
      *sites = {column, rows[column + 1]};
      sites += !(beside[column] & kObstacle);
    }
    *sites = kNoSite;
  }

  /// Gives the sites between two columns: those left on the row before and that row's obstacles.
  template <class Add>
  const Site* visit_between(std::int32_t before, std::int32_t after, const Site* site,
                            const std::uint8_t* old_bits, std::int32_t old_row, Add add) const {
    while (site->column <= before) ++site;
    for (std::int32_t column = before + 1; column < after;) {
      column = find_column(old_bits, column, after, kObstacle);
      for (; site->column < column; ++site) add(*site);
      for (; column < after && (old_bits[column] & kObstacle); ++column) add({column, old_row});
    }
    return site;
  }

  void sweep_down(std::int32_t bottom, std::int32_t top, const std::int32_t* above) {
    const auto most = static_cast<std::size_t>(stride_);
    above_.resize(std::max(above_.size(), 2 * most));
    start(bits(top), above, above_.data());
    std::size_t old = 0, used = most;
    above_begin_.assign(static_cast<std::size_t>(top - bottom), 0);
    for (std::int32_t row = top; row-- > bottom;) {
      if (above_.size() < used + most) above_.resize(2 * (used + most));
      const Site* site = above_.data() + old;
      Site* left = above_.data() + used;
      for_each_free_run(space_, row, [&](std::int32_t begin, std::int32_t after) {
        const std::int32_t before = begin - 1;
        RowEnvelope envelope(memory_, row, before, row);
        site = visit_between(before, after, site, bits(row + 1), row + 1,
                             [&](Site next) { envelope.add(next.column, next.row); });
        envelope.add(after, row);
        for (const auto *piece = envelope.begin() + 1, *end = envelope.end() - 1; piece < end;
             ++piece)
          *left++ = {piece->column, piece->site_row};
      });
      *left++ = kNoSite;
      above_begin_[static_cast<std::size_t>(row - bottom)] = old = used;
      used = static_cast<std::size_t>(left - above_.data());
    }
  }

  template <class Write>
  void sweep_up(std::int32_t bottom, std::int32_t top, const std::int32_t* below, Write write) {
    start(bits(bottom - 1), below, below_.data());
    for (std::int32_t row = bottom; row < top; ++row) {
      const Site* site = below_.data();
      const Site* above = above_.data() + above_begin_[static_cast<std::size_t>(row - bottom)];
      Site* left = left_.data();
      for_each_free_run(space_, row, [&](std::int32_t begin, std::int32_t after) {
        const std::int32_t before = begin - 1;
        RowEnvelope envelope(memory_, row, before, row);
        site = visit_between(before, after, site, bits(row - 1), row - 1, [&](Site next) {
          for (; above->column < next.column; ++above) envelope.add(above->column, above->row);
          if (above->column == next.column) {
            if (above->row - row < row - next.row) next.row = above->row;
            ++above;
          }
          envelope.add(next.column, next.row);
        });
        for (; above->column < after; ++above) envelope.add(above->column, above->row);
        envelope.add(after, row);
        envelope.for_each_piece(begin, after, [&](auto from, auto to, auto column, auto site_row) {
          write(row, begin, from, to, column, site_row);
        });
        for (const auto *piece = envelope.begin() + 1, *end = envelope.end() - 1; piece < end;
             ++piece) {
          *left = {piece->column, piece->site_row};
          left += piece->site_row < row;
        }
      });
      *left = kNoSite;
      std::swap(below_, left_);
    }
  }

  const FreeSpace& space_;
  std::int32_t stride_;
  std::vector<RowEnvelope::Piece> memory_;
  std::vector<Site> below_, left_;  ///< of the row before and of this one
  std::vector<Site> above_;         ///< of all rows of the band, one after the other
  std::vector<std::size_t> above_begin_;
};

}  // namespace stope::topology
