// Problem: which cells change their state when a part of the grid does, if small obstacles count
// as free.
// Idea: an obstacle is small or not by itself, so only those that reach into the window or touch it
// can change. Each is flooded until it is known to be large: as soon as it has enough cells or
// touches the border. Of the few that end before, the outline is walked, as trace_outlines does.
// Cost: linear in the window and, for each obstacle that reaches into it, in the least area.
#include "plugins/topology/update_free_space.hpp"

#include <algorithm>
#include <array>

namespace stope::topology {
namespace {

class FlipFinder {
 public:
  FlipFinder(const OccupancyGrid& grid, const OccupancyRule& rule, double least_area,
             const CellWindow& window, const FreeSpace& space, PaddedGrid<std::uint8_t>& kind)
      : grid_(grid),
        least_(least_occupied(rule)),
        unknown_is_obstacle_(rule.unknown_is_obstacle),
        least_area_(least_area),
        window_(window),
        space_(space),
        kind_(kind),
        step_{1, space.stride(), -1, -space.stride()} {}

  std::vector<CellIndex> run() {
    const std::int32_t right = std::min(window_.column + window_.width, space_.width() - 1);
    const std::int32_t top = std::min(window_.row + window_.height, space_.height() - 1);
    const auto for_each_cell = [&](auto visit) {
      for (std::int32_t row = std::max(window_.row - 1, 0); row <= top; ++row)
        for (std::int32_t column = std::max(window_.column - 1, 0); column <= right; ++column)
          visit(space_.index(column, row));
    };
    look_at_window();
    if (least_area_ > 0)
      for_each_cell([&](CellIndex cell) {
        if (kind_[cell] > kObstacleNow || !is_obstacle(cell)) return;
        // What hangs together with something large is large.
        if (kind_[cell - 1] == kLarge || kind_[cell - space_.stride()] == kLarge) {
          kind_[cell] = kLarge;
          seen_.push_back(cell);
        } else {
          judge(cell);
        }
      });
    for_each_cell([&](CellIndex cell) {
      const bool obstacle = kind_[cell] != kSmall && kind_[cell] != kFreeNow && is_obstacle(cell);
      if (obstacle == was_obstacle(cell)) return;
      flip(cell);
      if (obstacle) grow(cell);
    });
    // Of obstacles that are small now, what lies outside of the window.
    for (const CellIndex cell : small_)
      if (was_obstacle(cell) && kind_[cell] == kSmall) flip(cell);
    forget_all();
    std::sort(flipped_.begin(), flipped_.end());
    return std::move(flipped_);
  }

 private:
  /// kUnseen cells are outside of the window; in it they are kObstacleNow or kFreeNow at first.
  enum Kind : std::uint8_t { kUnseen, kObstacleNow, kFreeNow, kSeen, kSmall, kLarge, kFlipped };

  bool is_obstacle(std::int32_t column, std::int32_t row) const {
    if (!grid_.frame.contains({column, row})) return true;
    return is_obstacle(grid_.cells[grid_.frame.place({column, row})]);
  }
  bool is_obstacle(std::uint8_t value) const {
    return value == OccupancyGrid::kUnknown ? unknown_is_obstacle_ : value >= least_;
  }
  bool is_obstacle(CellIndex cell) const {
    if (kind_[cell] != kUnseen) return kind_[cell] != kFreeNow;
    // Outside of the window an obstacle that is small is not in free space's bits.
    return was_obstacle(cell) || is_obstacle(space_.column(cell), space_.row(cell));
  }
  bool is_margin(CellIndex cell) const {
    return !grid_.frame.contains({space_.column(cell), space_.row(cell)});
  }
  void look_at_window() {
    for (std::int32_t row = window_.row; row < window_.row + window_.height; ++row) {
      const CellIndex begin = space_.index(window_.column, row);
      const std::uint8_t* values = grid_.cells.data() + grid_.frame.place({window_.column, row});
      for (std::int32_t i = 0; i < window_.width; ++i)
        kind_[begin + i] = is_obstacle(values[i]) ? kObstacleNow : kFreeNow;
    }
  }
  void forget_all() {
    for (std::int32_t row = window_.row; row < window_.row + window_.height; ++row)
      std::fill_n(kind_.data() + space_.index(window_.column, row), window_.width,
                  std::uint8_t{kUnseen});
    for (const CellIndex cell : seen_) kind_[cell] = kUnseen;
    for (const CellIndex cell : flipped_) kind_[cell] = kUnseen;
  }
  bool was_obstacle(CellIndex cell) const { return space_[cell] & kObstacle; }

  void flip(CellIndex cell) {
    if (kind_[cell] == kFlipped) return;
    kind_[cell] = kFlipped;
    flipped_.push_back(cell);
  }

  /// Floods an obstacle as far as is needed to know whether it is small.
  void judge(CellIndex first) {
    const std::size_t begin = seen_.size();
    kind_[first] = kSeen;
    seen_.push_back(first);
    bool large = false;
    for (std::size_t i = begin; i < seen_.size() && !large; ++i) {
      for (const CellIndex step : step_) {
        const CellIndex next = seen_[i] + step;
        if (kind_[next] == kSeen || !is_obstacle(next)) continue;
        if (kind_[next] == kLarge || (kind_[next] == kUnseen && is_margin(next))) {
          large = true;
          break;
        }
        kind_[next] = kSeen;
        seen_.push_back(next);
      }
      large = large || static_cast<double>(seen_.size() - begin) >= least_area_;
    }
    large = large || area_of(begin) >= least_area_;
    for (std::size_t i = begin; i < seen_.size(); ++i) {
      kind_[seen_[i]] = large ? kLarge : kSmall;
      if (!large) small_.push_back(seen_[i]);
    }
  }

  /// What the outer outline of the obstacle flooded last encloses.
  double area_of(std::size_t begin) const {
    const CellIndex first =
        *std::min_element(seen_.begin() + static_cast<std::ptrdiff_t>(begin), seen_.end());
    constexpr int kSouthern = 3;
    CellIndex cell = first;
    int side = kSouthern;
    std::int64_t area = 0;
    do {
      if (side == 0) area += space_.column(cell) + 1;
      if (side == 2) area -= space_.column(cell);
      const int ahead = (side + 1) % 4;
      const CellIndex left_ahead = cell + step_[static_cast<std::size_t>(ahead)];
      if (!is_obstacle(left_ahead)) {
        side = ahead;
        continue;
      }
      const CellIndex right_ahead = left_ahead + step_[static_cast<std::size_t>(side)];
      cell = left_ahead;
      if (!is_obstacle(right_ahead)) continue;
      cell = right_ahead;
      side = (ahead + 2) % 4;
    } while (cell != first || side != kSouthern);
    return static_cast<double>(area);
  }

  /// What was a small obstacle is part of a large one.
  void grow(CellIndex first) {
    std::vector<CellIndex> open{first};
    while (!open.empty()) {
      const CellIndex cell = open.back();
      open.pop_back();
      for (const CellIndex step : step_) {
        const CellIndex next = cell + step;
        if (was_obstacle(next) || kind_[next] == kFlipped || !is_obstacle(next)) continue;
        flip(next);
        open.push_back(next);
      }
    }
  }

  const OccupancyGrid& grid_;
  std::uint8_t least_;
  bool unknown_is_obstacle_;
  double least_area_;
  CellWindow window_;
  const FreeSpace& space_;
  PaddedGrid<std::uint8_t>& kind_;
  std::array<CellIndex, 4> step_;
  std::vector<CellIndex> seen_, small_, flipped_;
};

}  // namespace

std::vector<CellIndex> find_flipped_cells(const OccupancyGrid& grid, const OccupancyRule& rule,
                                          double least_area, const CellWindow& window,
                                          const FreeSpace& space,
                                          PaddedGrid<std::uint8_t>& scratch) {
  return FlipFinder(grid, rule, least_area, window, space, scratch).run();
}

}  // namespace stope::topology
