// Problem: after a small change all of a large map's labels are written, because the payload is a
// new one; that should cost what the memory costs and no more.
// Idea: of a tile with one label only, or none, names need not be read. Rows are put together where
// the cache holds them, so the payload's memory is touched once.
// Cost: writing the labels, and reading the names of tiles with several.
#include "plugins/topology/regions/write_labels.hpp"

#include <algorithm>

namespace stope::topology {
namespace {

constexpr std::int32_t kSide = TileSet::kSide, kSeveral = -1;

/// The label of all `cells` cells of a tile, or kSeveral.
std::int32_t label_of_all(const std::vector<TilePart>& parts, std::int32_t cells,
                          const std::vector<std::int32_t>& label_of_name) {
  if (parts.empty()) return 0;
  const auto label = [&](const TilePart& part) {
    return label_of_name[static_cast<std::size_t>(part.name)];
  };
  for (const TilePart& part : parts) {
    if (label(part) != label(parts.front())) return kSeveral;
    cells -= part.free_cells;
  }
  return cells == 0 || label(parts.front()) == 0 ? label(parts.front()) : kSeveral;
}

}  // namespace

void write_labels(const GridFrame& frame, const PaddedGrid<std::int32_t>& names,
                  const TileParts& tiles, const std::vector<std::int32_t>& label_of_name,
                  LabelGrid& labels, const Checkpoint& checkpoint) {
  labels.frame = frame;
  labels.cells.clear();
  labels.cells.reserve(frame.size());
  std::vector<std::int32_t> together(static_cast<std::size_t>(frame.width));
  const std::int32_t across = (names.stride() + kSide - 1) / kSide;
  std::vector<std::int32_t> of_tile(static_cast<std::size_t>(across));
  // Tiles begin in the margin, at row and column -1.
  for (std::int32_t bottom = -1; bottom < frame.height; bottom += kSide) {
    checkpoint();
    const std::int32_t first = std::max(bottom, 0), top = std::min(bottom + kSide, frame.height);
    const auto ends = [&](std::int32_t tile) {
      return std::pair{std::max(tile * kSide - 1, 0),
                       std::min(tile * kSide - 1 + kSide, frame.width)};
    };
    for (std::int32_t tile = 0; tile < across; ++tile) {
      const auto [left, right] = ends(tile);
      of_tile[static_cast<std::size_t>(tile)] =
          label_of_all(tiles.parts(static_cast<std::size_t>((bottom + 1) / kSide * across + tile)),
                       (right - left) * (top - first), label_of_name);
    }
    for (std::int32_t row = first; row < top; ++row) {
      const std::int32_t* from = names.padded_row(row) + 1;
      for (std::int32_t tile = 0; tile < across; ++tile) {
        const auto [left, right] = ends(tile);
        const std::int32_t label = of_tile[static_cast<std::size_t>(tile)];
        std::int32_t* to = together.data();
        if (label != kSeveral) {
          if (left < right) std::fill(to + left, to + right, label);
          continue;
        }
        for (std::int32_t column = left; column < right; ++column)
          to[column] = label_of_name[static_cast<std::size_t>(from[column])];
      }
      labels.cells.insert(labels.cells.end(), together.begin(), together.end());
    }
  }
}

}  // namespace stope::topology
