#include "plugins/topology/regions/shared_names.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "plugins/topology/for_each_band.hpp"

namespace stope::topology {
namespace {

constexpr auto kTileSide = static_cast<std::int32_t>(LabelCells::kTileSide);
constexpr auto kTilesAcross = static_cast<std::int32_t>(LabelCells::kTilesAcrossBlock);
constexpr auto kBlockSide = static_cast<std::int32_t>(LabelCells::kBlockSide);

std::size_t blocks_along(std::int32_t cells) {
  return LabelCells::blocks_along(static_cast<std::size_t>(cells));
}

std::shared_ptr<const LabelCells::Tile> tile_of(const PaddedGrid<std::int32_t>& names,
                                                std::int32_t left, std::int32_t bottom) {
  if (left >= names.width() || bottom >= names.height()) return nullptr;
  auto tile = std::make_shared_for_overwrite<LabelCells::Tile>();
  const std::int32_t count = std::min(kTileSide, names.width() - left);
  const std::int32_t top = std::min(bottom + kTileSide, names.height());
  std::int32_t* to = tile->data();
  for (std::int32_t row = bottom; row < top; ++row, to += kTileSide)
    std::copy_n(names.padded_row(row) + 1 + left, count, to);
  return tile;
}

}  // namespace

SharedNames::SharedNames(const PaddedGrid<std::int32_t>& names, const Checkpoint& checkpoint)
    : width_(names.width()),
      height_(names.height()),
      blocks_across_(blocks_along(width_)),
      blocks_(blocks_across_ * blocks_along(height_)) {
  for_each_band(static_cast<std::int32_t>(blocks_.size()), checkpoint, [&] {
    return [&](std::int32_t block) {
      renew(names, static_cast<std::size_t>(block), static_cast<TileBits>(~TileBits{0}));
    };
  });
}

void SharedNames::update(const PaddedGrid<std::int32_t>& names, const ChangedSquares& changed,
                         const Checkpoint& checkpoint) {
  std::vector<TileBits> tiles(blocks_.size(), 0);
  std::vector<std::size_t> touched;
  const auto add = [&](std::int32_t column, std::int32_t row) {
    const std::size_t place = static_cast<std::size_t>(row / kBlockSide) * blocks_across_ +
                              static_cast<std::size_t>(column / kBlockSide);
    const std::int32_t tile =
        row % kBlockSide / kTileSide * kTilesAcross + column % kBlockSide / kTileSide;
    if (tiles[place] == 0) touched.push_back(place);
    tiles[place] |= static_cast<TileBits>(1U << tile);
  };
  // A square may be in four tiles: because of the margin they do not lie alike.
  changed.for_each([&](std::int32_t left, std::int32_t bottom) {
    const std::int32_t right = std::min(left + ChangedSquares::kSide, width_) - 1;
    const std::int32_t top = std::min(bottom + ChangedSquares::kSide, height_) - 1;
    left = std::max(left, 0), bottom = std::max(bottom, 0);
    if (left > right || bottom > top) return;
    for (const std::int32_t row : {bottom, top})
      for (const std::int32_t column : {left, right}) add(column, row);
  });
  for_each_band(static_cast<std::int32_t>(touched.size()), checkpoint, [&] {
    return [&](std::int32_t i) {
      const std::size_t place = touched[static_cast<std::size_t>(i)];
      renew(names, place, tiles[place]);
    };
  });
}

LabelCells SharedNames::labelled(std::vector<std::int32_t> label_of_name) const {
  return {width_, height_, blocks_, std::move(label_of_name)};
}

void SharedNames::renew(const PaddedGrid<std::int32_t>& names, std::size_t place, TileBits tiles) {
  const std::int32_t left = static_cast<std::int32_t>(place % blocks_across_) * kBlockSide;
  const std::int32_t bottom = static_cast<std::int32_t>(place / blocks_across_) * kBlockSide;
  auto block = blocks_[place] ? std::make_shared<LabelCells::Block>(*blocks_[place])
                              : std::make_shared<LabelCells::Block>();
  for (std::int32_t i = 0; i < kTilesAcross * kTilesAcross; ++i)
    if (tiles >> i & 1)
      (*block)[static_cast<std::size_t>(i)] = tile_of(names, left + i % kTilesAcross * kTileSide,
                                                      bottom + i / kTilesAcross * kTileSide);
  blocks_[place] = std::move(block);
}

}  // namespace stope::topology
