#include "plugins/topology/squared_distances.hpp"

#include <array>
#include <memory>

#include "plugins/topology/for_each_band.hpp"
#include "plugins/topology/nearest_obstacles.hpp"

namespace stope::topology {
namespace {

/// Writes a parabola over the cells from `begin` to before `end`, and something over cells before
/// them, not beyond `floor`.
void write_parabola(std::uint32_t* cells, std::int32_t floor, std::int32_t begin, std::int32_t end,
                    std::int32_t column, std::int32_t rows) {
  constexpr std::int32_t kLanes = 4;
  const auto square = [](std::int32_t a) {
    return static_cast<std::uint32_t>(a) * static_cast<std::uint32_t>(a);
  };
  const std::uint32_t least = square(rows);
  if (begin - floor < kLanes) {
    for (std::int32_t i = begin; i < end; ++i) cells[i] = square(i - column) + least;
    return;
  }
  // (x - 4)^2 = x^2 - (8 x - 16): four cells at once go on by additions.
  std::array<std::uint32_t, kLanes> value, step;
  for (std::int32_t k = 0; k < kLanes; ++k) {
    const std::int32_t x = end - kLanes + k - column;
    value[static_cast<std::size_t>(k)] = square(x) + least;
    step[static_cast<std::size_t>(k)] = static_cast<std::uint32_t>(16 - 8 * x);
  }
  while (true) {
    end -= kLanes;
    std::memcpy(cells + end, value.data(), sizeof value);
    if (end <= begin) return;
    for (std::size_t k = 0; k < kLanes; ++k) value[k] += step[k];
    for (std::size_t k = 0; k < kLanes; ++k) step[k] += 32;
  }
}

}  // namespace

void find_squared_distances(const FreeSpace& space, PaddedGrid<std::uint32_t>& distances,
                            const Checkpoint& checkpoint) {
  const BandBorders borders(space, checkpoint);
  for_each_band(borders.bands(), checkpoint, [&] {
    return [&, sweep = std::make_shared<BandSweep>(space)](std::int32_t band) {
      const std::int32_t bottom = band * BandBorders::kRows;
      const std::int32_t top = std::min(bottom + BandBorders::kRows, space.height());
      for (std::int32_t row = bottom; row < top; ++row) {
        std::uint32_t* cells = distances.padded_row(row) + 1;
        std::int32_t obstacles = 0;
        for_each_free_run(space, row, [&](std::int32_t begin, std::int32_t end) {
          std::fill(cells + obstacles, cells + begin, 0U);
          obstacles = end;
        });
        std::fill(cells + obstacles, cells + space.width(), 0U);
      }
      sweep->run(borders, band,
                 [&](auto row, auto first, auto begin, auto end, auto column, auto site_row) {
                   write_parabola(distances.padded_row(row) + 1, first, begin, end, column,
                                  site_row - row);
                 });
    };
  });
}

}  // namespace stope::topology
