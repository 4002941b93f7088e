#pragma once

#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "tests/benchmarks/topology/city_blocks.hpp"

namespace stope::topology {

/// 60 % free: smooth noise (random values every 256 cells plus half as much every 64, bilinear)
/// above its 40 % point.
inline OccupancyGrid synthetic() {
  const auto layer = [](int spacing, std::uint64_t seed) {
    const int count = kSide / spacing + 2;
    Random random(seed);
    std::vector<float> values(static_cast<std::size_t>(count * count));
    for (float& value : values) value = static_cast<float>(random.uniform());
    return [=](int x, int y) {
      const int i = x / spacing, k = y / spacing;
      const float s = static_cast<float>(x % spacing) / static_cast<float>(spacing);
      const float t = static_cast<float>(y % spacing) / static_cast<float>(spacing);
      const auto at = [&](int u, int v) { return values[static_cast<std::size_t>(v * count + u)]; };
      return (1 - t) * ((1 - s) * at(i, k) + s * at(i + 1, k)) +
             t * ((1 - s) * at(i, k + 1) + s * at(i + 1, k + 1));
    };
  };
  const auto coarse = layer(256, 1), fine = layer(64, 2);
  OccupancyGrid grid = empty_grid(kSide, kSide, 0.1);
  std::vector<float> height(grid.cells.size());
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      height[grid.frame.place({x, y})] = coarse(x, y) + 0.5F * fine(x, y);
  std::vector<float> sorted = height;
  const auto limit = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() * 2 / 5);
  std::nth_element(sorted.begin(), limit, sorted.end());
  for (std::size_t i = 0; i < height.size(); ++i)
    if (height[i] > *limit) grid.cells[i] = OccupancyGrid::kFree;
  return grid;
}

inline OccupancyGrid from_image(const cv::Mat& image, double resolution) {
  OccupancyGrid grid = empty_grid(image.cols, image.rows, resolution);
  for (int row = 0; row < image.rows; ++row)
    for (int column = 0; column < image.cols; ++column)
      if (image.at<std::uint8_t>(image.rows - 1 - row, column) > 127)
        grid.cells[grid.frame.place({column, row})] = OccupancyGrid::kFree;
  return grid;
}

/// The window with the most free cells among those at multiples of 512 cells.
inline OccupancyGrid fullest_window(const OccupancyGrid& mine) {
  std::int64_t most = -1;
  OccupancyGrid best;
  for (int row = 0; row + kSide <= mine.frame.height; row += 512) {
    for (int column = 0; column + kSide <= mine.frame.width; column += 512) {
      OccupancyGrid window = empty_grid(kSide, kSide, mine.frame.resolution);
      for (int y = 0; y < kSide; ++y)
        std::memcpy(&window.cells[window.frame.place({0, y})],
                    &mine.cells[mine.frame.place({column, row + y})], kSide);
      const auto free = std::count(window.cells.begin(), window.cells.end(), OccupancyGrid::kFree);
      if (free <= most) continue;
      most = free;
      best = std::move(window);
    }
  }
  return best;
}

/// The rasters of the real mine, at 0.1 and 0.5 m.
constexpr const char* kMineFine = "dapai_0p1m.png";
constexpr const char* kMineCoarse = "dapai_0p5m.png";

inline std::filesystem::path mine_raster(const char* name) {
  const char* data = std::getenv("STOPE_DATA");
  return std::filesystem::path(data ? data : STOPE_DEFAULT_DATA) / "open_pit_maps" / name;
}

/// Whether the mine is there; says if it is not.
inline bool has_mine() {
  const std::filesystem::path file = mine_raster(kMineFine);
  if (std::filesystem::exists(file)) return true;
  fmt::print("The mine's raster {} is not there, so it is left out; set STOPE_DATA.\n",
             file.string());
  return false;
}

/// One of them; empty if the mine is not there.
inline cv::Mat read_mine(const char* name = kMineFine) {
  if (!has_mine()) return {};
  ::setenv("OPENCV_IO_MAX_IMAGE_PIXELS", "1000000000", 1);
  return cv::imread(mine_raster(name).string(), cv::IMREAD_GRAYSCALE);
}

/// Time this thread has run, in milliseconds: what others do on the same core does not count.
inline double now_ms() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

}  // namespace stope::topology
