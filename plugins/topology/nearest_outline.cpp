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
#include <bit>
#include <cstdint>
#include <cstring>
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
        begin_(static_cast<std::size_t>(edges.stride())),
        height_(static_cast<std::size_t>(edges.stride())) {}

  void fill(std::int32_t row, const std::uint8_t* bits, const Reach* down, const Reach* up) {
    const CellIndex stride = edges_.stride();
    for (CellIndex i = 0; i < stride; ++i) reach_[i] = std::min(down[i], up[i]);
    for (CellIndex begin = next(bits, 1, stride, 0); begin < stride;) {
      const CellIndex end = next(bits, begin + 1, stride, kObstacle);
      build(begin - 1, end);
      assign(row, begin - 1, end, down);
      begin = next(bits, end + 1, stride, 0);
    }
  }

 private:
  /// The first cell from `i` on that is (kObstacle) or is not (0) an obstacle, or `end`.
  static CellIndex next(const std::uint8_t* bits, CellIndex i, CellIndex end, std::uint8_t wanted) {
    constexpr std::uint64_t kEight = 0x0101010101010101ULL * kObstacle;
    for (; i + 8 <= end; i += 8) {
      std::uint64_t cells = 0;
      std::memcpy(&cells, bits + i, 8);
      const std::uint64_t hits = (wanted ? cells : ~cells) & kEight;
      if (hits) return i + std::countr_zero(hits) / 8;
    }
    while (i < end && (bits[i] & kObstacle) != wanted) ++i;
    return std::min(i, end);
  }

  // Columns are counted from the obstacle before the run.
  void build(CellIndex before, CellIndex after) {
    count_ = 0;
    column_[0] = begin_[0] = height_[0] = 0;
    const Number last = after - before;
    const Reach* reach = reach_.data() + before;
    for (Number column = 1; column <= last; ++column) {
      const Number height = static_cast<Number>(reach[column]) * static_cast<Number>(reach[column]);
      std::size_t top = count_;
      // The first parabola is an obstacle at its own column: it is never left.
      while (beats(column, height, top)) --top;
      const Number apart = column - column_[top];
      const Number rise = apart * (column + column_[top]) + height - height_[top];
      // Most often the last column is the neighbour, which saves the slow division.
      const Number from = 1 + (apart == 1 ? rise / 2 : rise / (2 * apart));
      count_ = top;
      if (from >= last) continue;
      ++count_;
      column_[count_] = column;
      begin_[count_] = from;
      height_[count_] = height;
    }
  }

  /// Whether a column's parabola is lower already where that of the piece begins.
  bool beats(Number column, Number height, std::size_t piece) const {
    const Number own = begin_[piece] - column_[piece], other = begin_[piece] - column;
    return own * own + height_[piece] > other * other + height;
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
  std::vector<Number> column_, begin_, height_;  ///< by piece of the envelope
  std::size_t count_ = 0;
};

template <class Reach, class Number>
void find(const FreeSpace& space, const Outlines& outlines, EdgeGrid& edges,
          const Checkpoint& checkpoint) {
  const CellIndex stride = space.stride();
  PaddedGrid<Reach> down(space.width(), space.height());
  std::fill_n(down.padded_row(-1), stride, Reach{0});
  for (std::int32_t row = 0; row < space.height(); ++row) {
    if (row % kRowsBetweenCheckpoints == 0) checkpoint();
    step_reach(space.padded_row(row), down.padded_row(row - 1), down.padded_row(row), stride);
  }
  std::vector<Reach> up(static_cast<std::size_t>(stride), 0);
  RowEnvelope<Reach, Number> envelope(outlines, edges);
  for (std::int32_t row = space.height(); row-- > 0;) {
    if (row % kRowsBetweenCheckpoints == 0) checkpoint();
    step_reach(space.padded_row(row), up.data(), up.data(), stride);
    envelope.fill(row, space.padded_row(row), down.padded_row(row), up.data());
  }
}

}  // namespace

void find_nearest_outline(const FreeSpace& space, const Outlines& outlines, EdgeGrid& edges,
                          const Checkpoint& checkpoint) {
  // The sum of two squares of at most 32 000 fits 32 bits, whose division is the faster one.
  if (space.width() < 32000 && space.height() < 32000) {
    find<std::uint16_t, std::int32_t>(space, outlines, edges, checkpoint);
  } else {
    find<std::uint32_t, std::int64_t>(space, outlines, edges, checkpoint);
  }
}

}  // namespace stope::topology
