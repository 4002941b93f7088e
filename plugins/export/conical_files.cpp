#include "plugins/export/conical_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "plugins/export/cone_colour.hpp"
#include "plugins/export/conical_yaml.hpp"
#include "plugins/export/region_colours.hpp"
#include "plugins/export/region_pieces.hpp"
#include "plugins/export/text_bytes.hpp"
#include "stope/error.hpp"

namespace stope::exports {
namespace {

void check(const RegionMap& map) {
  if (map.labels.cells.empty() || map.labels.cells.size() != map.labels.frame.size())
    throw Error("the region map has no labels, or not as many as its frame has cells");
  if (!map.semantics.empty() && map.semantics.size() != map.regions.size()) {
    throw Error(
        fmt::format("the region map has {} regions and {} semantics: expected as many, or "
                    "none",
                    map.regions.size(), map.semantics.size()));
  }
  if (map.adjacency.size() % 2 != 0)
    throw Error("the region map's adjacency is no list of pairs: it has an odd length");
  std::pair<std::uint32_t, std::uint32_t> before{0, 0};
  for (std::size_t i = 0; i < map.adjacency.size(); i += 2) {
    const std::pair pair{map.adjacency[i], map.adjacency[i + 1]};
    if (pair.second >= map.regions.size() || pair.first >= pair.second || pair <= before) {
      throw Error(fmt::format(
          "the region map's adjacent pair ({}, {}) is wrong: expected two of its {} regions, the "
          "lower first, pairs in increasing order",
          pair.first, pair.second, map.regions.size()));
    }
    before = pair;
  }
  for (std::size_t i = 1; i < map.regions.size(); ++i) {
    if (map.regions[i].id <= map.regions[i - 1].id)
      throw Error(fmt::format("the region map's ids do not increase: {} is followed by {}",
                              map.regions[i - 1].id, map.regions[i].id));
  }
}

/// What a cell holds when no grid says so: regions are of free space, the rest nobody knows.
std::uint8_t assumed(std::int32_t piece) {
  return piece < 0 ? OccupancyGrid::kUnknown : OccupancyGrid::kFree;
}

std::vector<std::uint8_t> picture(const GridFrame& frame, const RegionPieces& pieces,
                                  const RegionColours& colours, int floor,
                                  const OccupancyGrid* grid) {
  // One row of the table for each hue, and a last one for no region.
  const auto hues = static_cast<std::size_t>(colours.hues);
  std::vector<std::array<Rgb, 256>> table(hues + 1);
  const ConeColours cone(floor, colours.hues);
  for (std::size_t cell = 0; cell < 256; ++cell) {
    const auto value = static_cast<std::uint8_t>(cell);
    for (std::size_t hue = 0; hue < hues; ++hue)
      table[hue][cell] = cone.region(static_cast<int>(hue), value);
    table[hues][cell] = ConeColours::grey(value);
  }
  std::vector<std::uint8_t> bytes =
      bytes_of(fmt::format("P6\n{} {}\n255\n", frame.width, frame.height));
  bytes.reserve(bytes.size() + 3 * frame.size());
  for (std::int32_t row = frame.height - 1; row >= 0; --row) {
    for (std::size_t place = frame.place({0, row}); place < frame.place({0, row + 1}); ++place) {
      const std::int32_t piece = pieces.of_cell[place];
      const std::size_t hue = piece < 0 ? hues : colours.of_piece[static_cast<std::size_t>(piece)];
      const Rgb& colour = table[hue][grid ? grid->cells[place] : assumed(piece)];
      bytes.insert(bytes.end(), colour.begin(), colour.end());
    }
  }
  return bytes;
}

}  // namespace

Artefact conical_files(const RegionMap& regions, const OccupancyGrid* grid,
                       const ConicalStyle& style, Context& context) {
  check(regions);
  const GridFrame& frame = regions.labels.frame;
  if (grid && (!(grid->frame == frame) || grid->cells.size() != frame.size())) {
    throw Error(fmt::format(
        "the grid ({} x {} cells of {} m) is another than the regions were made of ({} x {} "
        "cells of {} m): wire the one they were made of",
        grid->frame.width, grid->frame.height, grid->frame.resolution, frame.width, frame.height,
        frame.resolution));
  }
  const RegionPieces pieces = region_pieces(regions);
  const RegionColours colours = colour_regions(regions, pieces);
  const int floor = std::max(3, static_cast<int>(std::lround(style.floor * 255)));
  const bool trinary =
      !grid || std::all_of(grid->cells.begin(), grid->cells.end(), [](std::uint8_t cell) {
        return cell == OccupancyGrid::kFree || cell >= OccupancyGrid::kOccupied;
      });
  context.info(fmt::format("regions: {}, pieces of them: {}, hues: {}", regions.regions.size(),
                           pieces.region.size(), colours.hues));
  const ConicalSettings settings{style.stem + ".ppm", floor, trinary, grid != nullptr};
  const std::string yaml = conical_yaml(regions, pieces, colours, settings);
  return {{{"ppm", picture(frame, pieces, colours, floor, grid)}, {"yaml", bytes_of(yaml)}}};
}

}  // namespace stope::exports
