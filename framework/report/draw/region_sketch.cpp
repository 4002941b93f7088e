#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "framework/report/draw/colour_ramp.hpp"
#include "framework/report/draw/grid_picture.hpp"
#include "framework/report/draw/region_colouring.hpp"
#include "framework/report/draw/sketches.hpp"
#include "framework/report/quantity_text.hpp"

namespace stope::report {
namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// A small grid's cells become squares of up to so many pixels, so that outlines are thin beside
// them.
constexpr int kLargestSquare = 8;

/// The label in the middle of each pixel's block of cells; row 0 at the top.
struct LabelPicture {
  int width = 0, height = 0;
  std::vector<std::int32_t> labels;

  explicit LabelPicture(const RegionLabels& grid) {
    const Blocks blocks(grid.frame);
    width = blocks.picture_width, height = blocks.picture_height;
    std::vector<std::int32_t> room;
    for (int y = 0; y < height; ++y) {
      const int row = (blocks.row_begin(y) + blocks.row_end(y)) / 2;
      const auto cells = grid.cells.read(grid.frame.place({0, row}),
                                         static_cast<std::size_t>(grid.frame.width), room);
      for (int x = 0; x < width; ++x) {
        const int column = (blocks.column_begin(x) + blocks.column_begin(x + 1)) / 2;
        labels.push_back(cells[static_cast<std::size_t>(column)]);
      }
    }
  }

  /// 0 outside.
  std::int32_t at(int x, int y) const {
    if (x < 0 || y < 0 || x >= width || y >= height) return 0;
    return labels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

Pairs contacts_in(const LabelPicture& picture) {
  Pairs pairs;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const std::int32_t own = picture.at(x, y);
      for (const std::int32_t other : {picture.at(x + 1, y), picture.at(x, y + 1)}) {
        if (own <= 0 || other <= 0 || own == other) continue;
        const auto a = static_cast<std::uint32_t>(own - 1);
        const auto b = static_cast<std::uint32_t>(other - 1);
        if (pairs.empty() || pairs.back() != std::pair(a, b)) pairs.emplace_back(a, b);
      }
    }
  }
  return pairs;
}

Colour outline_of(Colour colour) {
  for (std::size_t k = 0; k < 3; ++k) colour[k] = static_cast<std::uint8_t>(colour[k] * 11 / 20);
  return colour;
}

/// The regions in colours of which neighbours differ, with dark outlines.
Picture region_picture(const RegionMap& map) {
  const RegionLabels& grid = map.labels;
  const LabelPicture sampled(grid);
  Pairs neighbours = contacts_in(sampled);
  for (std::size_t i = 0; i + 1 < map.adjacency.size(); i += 2)
    neighbours.emplace_back(map.adjacency[i], map.adjacency[i + 1]);
  const auto number = region_colouring(map.regions.size(), std::move(neighbours));
  const Picture plain = grid_picture(grid.frame, grid.cells, [&](std::int32_t label) {
    const auto place = static_cast<std::size_t>(label) - 1;
    return label_colour(label > 0 && place < number.size() ? number[place] + 1 : label);
  });
  const int square =
      std::clamp(kLongestSide / std::max(plain.width, plain.height), 1, kLargestSquare);
  Picture picture{plain.width * square, plain.height * square, {}};
  picture.pixels.resize(static_cast<std::size_t>(picture.width) *
                        static_cast<std::size_t>(picture.height));
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const int column = x / square, row = y / square;
      const std::int32_t own = sampled.at(column, row);
      // Of large grids, whose pixels are no squares, only two sides, or lines would be double.
      const bool edge =
          own > 0 && ((x % square == square - 1 && sampled.at(column + 1, row) != own) ||
                      (y % square == square - 1 && sampled.at(column, row + 1) != own) ||
                      (square > 1 && x % square == 0 && sampled.at(column - 1, row) != own) ||
                      (square > 1 && y % square == 0 && sampled.at(column, row - 1) != own));
      const Colour colour = plain.at(column, row);
      picture.at(x, y) = edge ? outline_of(colour) : colour;
    }
  }
  return picture;
}

}  // namespace

Sketch sketch_of(const RegionMap& map) {
  Sketch sketch;
  sketch.kind = "Regions";
  const std::size_t pairs = map.adjacency.size() / 2;
  double area = 0;
  for (const Region& region : map.regions) area += region.area;
  sketch.caption =
      fmt::format("{}, {}, {} m²", count_text(map.regions.size(), "region", "regions"),
                  count_text(pairs, "neighbouring pair", "neighbouring pairs"), number_text(area));
  if (is_whole(map.labels)) sketch.raster = Raster{map.labels.frame, region_picture(map), false};
  for (std::size_t i = 0; i < pairs; ++i) {
    const std::size_t from = map.adjacency[2 * i], to = map.adjacency[2 * i + 1];
    if (from >= map.regions.size() || to >= map.regions.size()) continue;
    const Region &a = map.regions[from], &b = map.regions[to];
    sketch.strokes.push_back({"link", {{a.x, a.y}, {b.x, b.y}}, false, ""});
  }
  for (std::size_t i = 0; i < map.regions.size(); ++i) {
    const Region& region = map.regions[i];
    const bool named = i < map.semantics.size() && !map.semantics[i].empty();
    sketch.marks.push_back(
        {"region",
         {region.x, region.y},
         fmt::format("{}{} m²", named ? map.semantics[i] + ", " : "", number_text(region.area))});
  }
  if (!map.regions.empty()) sketch.legend.push_back({"region", "", "centre of a region"});
  if (pairs > 0) sketch.legend.push_back({"link", "", "neighbours"});
  return sketch;
}

}  // namespace stope::report
