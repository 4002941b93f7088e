// Problem: after a small change all of a large map's labels are written, because the payload is a
// new one; that should cost what the memory costs and no more.
// Idea: of a tile with one label only, or none, names need not be read; of one with one label and
// obstacles, only what is free. Rows are put together where the cache holds them, so the payload's
// memory is touched once.
// Cost: writing the labels, and reading the names of tiles with several.
#include "plugins/topology/regions/write_labels.hpp"

#include <algorithm>
#include <utility>

namespace stope::topology {
namespace {

constexpr std::int32_t kSide = TileSet::kSide;

class LabelRows {
 public:
  LabelRows(const GridFrame& frame, const PaddedGrid<std::int32_t>& names, const TileParts& tiles,
            const std::vector<std::int32_t>& label_of_name, const Ground* ground)
      : frame_(frame),
        names_(names),
        tiles_(tiles),
        label_of_name_(label_of_name),
        ground_(ground),
        of_tile_(static_cast<std::size_t>((names.stride() + kSide - 1) / kSide)),
        labels_(static_cast<std::size_t>(frame.width)) {}

  /// Makes ready for the rows from `first` to before `top`, which are in one row of tiles.
  void look_at(std::int32_t first, std::int32_t top) {
    const std::size_t row = static_cast<std::size_t>((first + 1) / kSide) * of_tile_.size();
    for (std::size_t tile = 0; tile < of_tile_.size(); ++tile)
      of_tile_[tile] = what_is_in(row + tile, (end(tile) - begin(tile)) * (top - first));
  }

  const std::vector<std::int32_t>& write(std::int32_t row) {
    for (std::size_t tile = 0; tile < of_tile_.size(); ++tile) {
      const std::int32_t left = begin(tile), right = end(tile);
      const auto [kind, label] = of_tile_[tile];
      if (kind == Kind::kOneLabel) {
        std::fill(labels_.begin() + left, labels_.begin() + std::max(left, right), label);
      } else if (kind == Kind::kWhereFree) {
        const CellIndex first = names_.index(0, row);
        for (std::int32_t column = left; column < right; ++column)
          labels_[static_cast<std::size_t>(column)] = ground_->free(first + column) ? label : 0;
      } else {
        const std::int32_t* names = names_.padded_row(row) + 1;
        for (std::int32_t column = left; column < right; ++column)
          labels_[static_cast<std::size_t>(column)] =
              label_of_name_[static_cast<std::size_t>(names[column])];
      }
    }
    return labels_;
  }

 private:
  enum class Kind { kOneLabel, kWhereFree, kSeveral };
  using OfTile = std::pair<Kind, std::int32_t>;

  // Tiles begin in the margin, at column -1.
  std::int32_t begin(std::size_t tile) const {
    return std::max(static_cast<std::int32_t>(tile) * kSide - 1, 0);
  }
  std::int32_t end(std::size_t tile) const {
    return std::min((static_cast<std::int32_t>(tile) + 1) * kSide - 1, frame_.width);
  }

  OfTile what_is_in(std::size_t tile, std::int32_t cells) const {
    const auto& parts = tiles_.parts(tile);
    const auto label = [&](const TilePart& part) {
      return label_of_name_[static_cast<std::size_t>(part.name)];
    };
    if (parts.empty()) return {Kind::kOneLabel, 0};
    for (const TilePart& part : parts) {
      if (label(part) != label(parts.front())) return {Kind::kSeveral, 0};
      cells -= part.free_cells;
    }
    if (cells == 0 || label(parts.front()) == 0) return {Kind::kOneLabel, label(parts.front())};
    if (ground_ && tiles_.nameless(tile) == 0) return {Kind::kWhereFree, label(parts.front())};
    return {Kind::kSeveral, 0};
  }

  const GridFrame& frame_;
  const PaddedGrid<std::int32_t>& names_;
  const TileParts& tiles_;
  const std::vector<std::int32_t>& label_of_name_;
  const Ground* ground_;
  std::vector<OfTile> of_tile_;  ///< by column of tiles
  std::vector<std::int32_t> labels_;
};

}  // namespace

void write_labels(const GridFrame& frame, const PaddedGrid<std::int32_t>& names,
                  const TileParts& tiles, const std::vector<std::int32_t>& label_of_name,
                  LabelGrid& labels, const Checkpoint& checkpoint, const Ground* ground) {
  labels.frame = frame;
  labels.cells.clear();
  labels.cells.reserve(frame.size());
  LabelRows rows(frame, names, tiles, label_of_name, ground);
  for (std::int32_t bottom = -1; bottom < frame.height; bottom += kSide) {
    checkpoint();
    const std::int32_t first = std::max(bottom, 0), top = std::min(bottom + kSide, frame.height);
    rows.look_at(first, top);
    for (std::int32_t row = first; row < top; ++row) {
      const std::vector<std::int32_t>& written = rows.write(row);
      labels.cells.insert(labels.cells.end(), written.begin(), written.end());
    }
  }
}

}  // namespace stope::topology
