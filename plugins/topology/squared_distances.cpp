#include "plugins/topology/squared_distances.hpp"

#include <memory>
#include <vector>

#include "plugins/topology/for_each_band.hpp"
#include "plugins/topology/nearest_obstacles.hpp"

namespace stope::topology {
namespace {

/// The squares of whole numbers on both sides of 0: a parabola is a stretch of them, raised. What
/// is near 0 is what is needed mostly, and stays in the nearest cache.
class Squares {
 public:
  explicit Squares(std::int32_t most) : zero_(most) {
    for (std::int32_t x = -most; x <= most; ++x) squares_.push_back(square(x));
  }
  static std::uint32_t square(std::int32_t x) {
    return static_cast<std::uint32_t>(x) * static_cast<std::uint32_t>(x);
  }
  const std::uint32_t* from(std::int32_t x) const { return squares_.data() + zero_ + x; }

 private:
  std::ptrdiff_t zero_;
  std::vector<std::uint32_t> squares_;
};

/// Writes (column - i)^2 + rows^2 to the cells i from `begin` to before `end`, and something to
/// cells before them, not beyond `floor`.
void write_parabola(std::uint32_t* cells, std::int32_t floor, std::int32_t begin, std::int32_t end,
                    std::int32_t column, std::int32_t rows, const Squares& squares) {
  constexpr std::int32_t kLanes = 4;
  const std::uint32_t least = Squares::square(rows);
  if (begin - floor < kLanes) {
    const std::uint32_t* square = squares.from(begin - column);
    for (std::int32_t i = begin; i < end; ++i) cells[i] = *square++ + least;
    return;
  }
  const std::uint32_t* square = squares.from(end - column);
  for (cells += end; begin < end; end -= kLanes) {
    cells -= kLanes;
    square -= kLanes;
    for (std::int32_t k = 0; k < kLanes; ++k) cells[k] = square[k] + least;
  }
}

}  // namespace

void find_squared_distances(const FreeSpace& space, PaddedGrid<std::uint32_t>& distances,
                            const Checkpoint& checkpoint) {
  const BandBorders borders(space, checkpoint);
  // Lanes before a piece are read, too.
  const Squares squares(space.stride() + 4);
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
                                  site_row - row, squares);
                 });
    };
  });
}

}  // namespace stope::topology
