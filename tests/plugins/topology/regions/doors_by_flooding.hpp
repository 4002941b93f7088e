#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace stope::topology {

/// What two labels have in common, by brute force, on a lattice twice as fine as the grid: cells
/// are at its odd places, edges and corners between them, and a cell has all places around it.
class DoorsByFlooding {
 public:
  using Pair = std::pair<std::int32_t, std::int32_t>;  ///< labels, the lower first
  using Place = std::pair<std::int32_t, std::int32_t>;

  /// `label(column, row)` of a cell is 0 if it has none.
  template <class Label>
  DoorsByFlooding(std::int32_t width, std::int32_t height, Label label) {
    for (std::int32_t y = 1; y < 2 * height; ++y)
      for (std::int32_t x = 1; x < 2 * width; ++x) {
        const std::int32_t left = (x - 1) / 2, right = x / 2, below = (y - 1) / 2, above = y / 2;
        const std::array<std::int32_t, 4> around{label(left, below), label(right, below),
                                                 label(left, above), label(right, above)};
        for (const std::int32_t a : around)
          for (const std::int32_t b : around)
            if (a != 0 && a < b) common_[{a, b}][{x, y}] = kNone;
      }
    for (auto& [pair, places] : common_)
      for (auto& [place, door] : places)
        if (door == kNone) flood(places, place, count_[pair]++);
  }

  /// How many doors each two have that touch.
  const std::map<Pair, std::int32_t>& count() const { return count_; }
  /// Which of their doors the place between two cells is in, counted from 0.
  std::int32_t door_at(Pair pair, Place place) const { return common_.at(pair).at(place); }

 private:
  static constexpr std::int32_t kNone = -1;
  static void flood(std::map<Place, std::int32_t>& places, Place from, std::int32_t door) {
    std::vector<Place> open{from};
    while (!open.empty()) {
      const auto [x, y] = open.back();
      open.pop_back();
      const auto at = places.find({x, y});
      if (at == places.end() || at->second != kNone) continue;
      at->second = door;
      open.insert(open.end(), {{x + 1, y}, {x - 1, y}, {x, y + 1}, {x, y - 1}});
    }
  }

  std::map<Pair, std::map<Place, std::int32_t>> common_;
  std::map<Pair, std::int32_t> count_;
};

}  // namespace stope::topology
