// Problem: for each free cell, which obstacle cell is nearest, exactly.
// Idea (Meijster, Roerdink and Hesselink 2000; Felzenszwalb and Huttenlocher 2012): the nearest
// obstacle within each column is found by counting up and down; along a row the squared distance is
// then the lower envelope of one parabola a column. A run of free cells has an obstacle at both
// ends, which beats everything behind it, so each run is an envelope of its own and obstacles cost
// nothing.
// Cost: linear in the cells; about two additions a cell down the columns, amortised one division
// and two comparisons a free cell along the rows.
#include "plugins/topology/nearest_outline.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace stope::topology {
namespace {

/// One step along the columns: rows to the nearest obstacle, 0 in obstacles.
template <class Reach>
void step_reach(const std::uint8_t* bits, const Reach* previous, Reach* next, CellIndex count) {
  for (CellIndex i = 0; i < count; ++i) {
    const auto free = static_cast<Reach>((bits[i] & kObstacle) - 1);  // all ones, or 0
    next[i] = static_cast<Reach>(static_cast<Reach>(previous[i] + 1) & free);
  }
}

/// Envelopes of the runs of one row. `Number` holds the sum of two squared distances.
template <class Reach, class Number>
class RowEnvelope {
 public:
  RowEnvelope(const Outlines& outlines, EdgeGrid& edges)
      : outlines_(outlines),
        edges_(edges),
        reach_(static_cast<std::size_t>(edges.stride())),
        column_(static_cast<std::size_t>(edges.stride())),
        begin_(static_cast<std::size_t>(edges.stride())) {}

  void fill(std::int32_t row, const std::uint8_t* bits, const Reach* down, const Reach* up) {
    const CellIndex stride = edges_.stride();
    for (CellIndex i = 0; i < stride; ++i) reach_[i] = std::min(down[i], up[i]);
    for (CellIndex i = 1; i + 1 < stride; ++i) {
      if (bits[i] & kObstacle) continue;
      CellIndex end = i + 1;
      while (!(bits[end] & kObstacle)) ++end;
      build(i - 1, end);
      assign(row, i - 1, end, down);
      i = end;
    }
  }

 private:
  Number squared_reach(CellIndex column) const {
    return static_cast<Number>(reach_[static_cast<std::size_t>(column)]) *
           static_cast<Number>(reach_[static_cast<std::size_t>(column)]);
  }

  // Columns are counted from the obstacle before the run.
  void build(CellIndex before, CellIndex after) {
    count_ = 0;
    column_[0] = 0;
    begin_[0] = 0;
    const Number last = after - before;
    for (Number column = 1; column <= last; ++column) {
      const Number height = squared_reach(before + static_cast<CellIndex>(column));
      while (true) {
        const Number at = begin_[count_], top = column_[count_];
        const Number top_height = squared_reach(before + static_cast<CellIndex>(top));
        if ((at - top) * (at - top) + top_height <= (at - column) * (at - column) + height) {
          const Number from =
              1 + (column * column - top * top + height - top_height) / (2 * (column - top));
          if (from < last) {
            ++count_;
            column_[count_] = column;
            begin_[count_] = from;
          }
          break;
        }
        // The first parabola is an obstacle at its own column: it is never popped.
        --count_;
      }
    }
  }

  void assign(std::int32_t row, CellIndex before, CellIndex after, const Reach* down) {
    std::int32_t* edges = edges_.padded_row(row);
    CellIndex end = after;
    for (std::size_t piece = count_ + 1; piece-- > 0;) {
      const auto begin = std::max(before + 1, before + static_cast<CellIndex>(begin_[piece]));
      const CellIndex column = before + static_cast<CellIndex>(column_[piece]);
      const auto reach = static_cast<CellIndex>(reach_[static_cast<std::size_t>(column)]);
      const bool below = down[column] <= reach_[static_cast<std::size_t>(column)];
      const CellIndex source = edges_.stride() * (row + 1 + (below ? -reach : reach)) + column;
      const auto& sides = outlines_.sides[static_cast<std::size_t>(edges_[source])];
      // An obstacle is seen from the side of the larger difference; that side is free, or what
      // lies there would be nearer.
      const CellIndex west = std::clamp(column - reach, begin, end);
      const CellIndex east = std::clamp(column + reach + 1, west, end);
      std::fill(edges + begin, edges + west, sides[kWest]);
      std::fill(edges + west, edges + east, sides[below ? kNorth : kSouth]);
      std::fill(edges + east, edges + end, sides[kEast]);
      end = begin;
    }
  }

  const Outlines& outlines_;
  EdgeGrid& edges_;
  std::vector<Reach> reach_;
  std::vector<Number> column_, begin_;
  std::size_t count_ = 0;
};

template <class Reach, class Number>
void find(const FreeSpace& space, const Outlines& outlines, EdgeGrid& edges) {
  const CellIndex stride = space.stride();
  PaddedGrid<Reach> down(space.width(), space.height());
  std::fill_n(down.padded_row(-1), stride, Reach{0});
  for (std::int32_t row = 0; row < space.height(); ++row)
    step_reach(space.padded_row(row), down.padded_row(row - 1), down.padded_row(row), stride);
  std::vector<Reach> up(static_cast<std::size_t>(stride), 0);
  RowEnvelope<Reach, Number> envelope(outlines, edges);
  for (std::int32_t row = space.height(); row-- > 0;) {
    step_reach(space.padded_row(row), up.data(), up.data(), stride);
    envelope.fill(row, space.padded_row(row), down.padded_row(row), up.data());
  }
}

}  // namespace

void find_nearest_outline(const FreeSpace& space, const Outlines& outlines, EdgeGrid& edges) {
  // The sum of two squares of at most 32 000 fits 32 bits, whose division is the faster one.
  if (space.width() < 32000 && space.height() < 32000) {
    find<std::uint16_t, std::int32_t>(space, outlines, edges);
  } else {
    find<std::uint32_t, std::int64_t>(space, outlines, edges);
  }
}

}  // namespace stope::topology
