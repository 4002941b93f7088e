#include "stope/label_cells.hpp"

#include <gtest/gtest.h>

#include "stope/digest.hpp"
#include "stope/layout.hpp"
#include "stope/payloads.hpp"
#include "stope/random.hpp"

namespace stope {
namespace {

constexpr auto kTile = static_cast<std::int32_t>(LabelCells::kTileSide);
constexpr auto kAcross = static_cast<std::int32_t>(LabelCells::kTilesAcrossBlock);
constexpr auto kBlock = static_cast<std::int32_t>(LabelCells::kBlockSide);

/// Labels as a plain array, and the same ones shared.
struct Both {
  std::vector<std::int32_t> plain;
  LabelCells shared;
};

Both random_labels(std::int32_t width, std::int32_t height, Random& random) {
  constexpr std::int32_t kNames = 40;
  std::vector<std::int32_t> label_of_name{0};
  for (std::int32_t i = 1; i < kNames; ++i)
    label_of_name.push_back(static_cast<std::int32_t>(random.below(1000)));
  const std::int32_t across = (width + kBlock - 1) / kBlock, up = (height + kBlock - 1) / kBlock;
  std::vector<LabelCells::Block> blocks(static_cast<std::size_t>(across * up));
  std::vector<std::shared_ptr<LabelCells::Tile>> tiles(16 * blocks.size());
  Both both;
  for (std::int32_t row = 0; row < height; ++row)
    for (std::int32_t column = 0; column < width; ++column) {
      const auto name = static_cast<std::int32_t>(random.below(kNames));
      both.plain.push_back(label_of_name[static_cast<std::size_t>(name)]);
      const auto block = static_cast<std::size_t>(row / kBlock * across + column / kBlock);
      const auto tile =
          static_cast<std::size_t>(row % kBlock / kTile * kAcross + column % kBlock / kTile);
      std::shared_ptr<LabelCells::Tile>& own = tiles[16 * block + tile];
      if (!own) {
        own = std::make_shared<LabelCells::Tile>();
        own->fill(1'000'000'000);  // past the grid's sides: no name at all
        blocks[block][tile] = own;
      }
      (*own)[static_cast<std::size_t>(row % kTile * kTile + column % kTile)] = name;
    }
  LabelCells::Blocks shared;
  for (const LabelCells::Block& block : blocks)
    shared.push_back(std::make_shared<LabelCells::Block>(block));
  both.shared = LabelCells(width, height, std::move(shared), std::move(label_of_name));
  return both;
}

template <class T>
std::vector<std::byte> bytes_of(const T& value) {
  ByteBuffer buffer;
  encode(value, buffer);
  return buffer.bytes();
}

TEST(LabelCells, OfBothFormsAreWrittenAsAVectorIs) {
  Random random(1);
  const std::pair<std::int32_t, std::int32_t> sizes[] = {
      {1, 1}, {64, 64}, {65, 63}, {1, 300}, {300, 1}, {128, 64}, {63, 65}, {200, 130}, {3, 20000}};
  for (const auto& [width, height] : sizes) {
    const auto [plain, shared] = random_labels(width, height, random);
    const LabelCells dense = plain;
    for (const LabelCells& cells : {dense, shared}) {
      ASSERT_EQ(bytes_of(cells), bytes_of(plain)) << width << " x " << height;
      EXPECT_EQ(digest_of(cells), digest_of(plain));
      EXPECT_EQ(encoded_size(cells), encoded_size(plain));
      EXPECT_EQ(encoded_size(cells), bytes_of(plain).size());
      EXPECT_EQ(cells.size(), plain.size());
      EXPECT_EQ(cells.to_vector(), plain);
      LabelCells back;
      const std::vector<std::byte> bytes = bytes_of(cells);
      ByteReader reader(bytes);
      decode(back, reader);
      EXPECT_EQ(reader.remaining(), 0U);
      EXPECT_EQ(back.to_vector(), plain);
    }
  }
}

TEST(LabelCells, WithoutCellsAreWrittenAsAnEmptyVector) {
  EXPECT_TRUE(LabelCells().empty());
  EXPECT_EQ(bytes_of(LabelCells()), bytes_of(std::vector<std::int32_t>()));
}

TEST(LabelCells, OfARegionMapAreWrittenAsALabelGridIs) {
  Random random(2);
  const auto [plain, shared] = random_labels(330, 70, random);
  LabelGrid grid;
  grid.frame = {330, 70, 0.5, {1, 2, 0.25}};
  grid.cells = plain;
  grid.names = {"", "kitchen"};
  grid.changed = ChangedWindow{1, 0, 1, 1, 7};
  const RegionLabels labels{grid.frame, shared, grid.names, grid.changed};
  EXPECT_EQ(bytes_of(labels), bytes_of(grid));
}

TEST(LabelCells, AreReadFromAnyPlaceOn) {
  Random random(3);
  const auto [plain, shared] = random_labels(350, 290, random);
  const LabelCells dense = plain;
  std::vector<std::int32_t> room;
  for (int i = 0; i < 500; ++i) {
    const std::size_t begin = random.below(plain.size());
    const std::size_t count = random.below(plain.size() - begin + 1);
    EXPECT_EQ(shared[begin], plain[begin]);
    EXPECT_EQ(dense[begin], plain[begin]);
    for (const LabelCells& cells : {dense, shared}) {
      const auto read = cells.read(begin, count, room);
      ASSERT_TRUE(std::equal(read.begin(), read.end(), plain.begin() + static_cast<long>(begin),
                             plain.begin() + static_cast<long>(begin + count)));
    }
  }
}

TEST(LabelCells, ThatAreChangedLeaveWhatTheyShareAsItIs) {
  Random random(4);
  const auto [plain, shared] = random_labels(100, 100, random);
  LabelCells copy = shared;
  copy.dense()[5] = -7;
  EXPECT_EQ(copy[5], -7);
  EXPECT_EQ(copy.size(), plain.size());
  EXPECT_EQ(shared.to_vector(), plain);
}

TEST(LabelCells, RefuseAnotherNumberOfBlocksThanTheGridHas) {
  const auto blocks = [](std::size_t count) {
    return LabelCells::Blocks(count, std::make_shared<LabelCells::Block>());
  };
  EXPECT_NO_THROW(LabelCells(257, 256, blocks(2), {0}));
  EXPECT_THROW(LabelCells(257, 256, blocks(1), {0}), Error);
  EXPECT_THROW(LabelCells(257, 256, blocks(3), {0}), Error);
  EXPECT_THROW(LabelCells(0, 64, {}, {0}), Error);
}

TEST(LabelCells, AreAnotherLayoutThanAVector) {
  EXPECT_NE(layout_text<LabelCells>(), layout_text<std::vector<std::int32_t>>());
  EXPECT_NE(layout_text<RegionLabels>(), layout_text<LabelGrid>());
}

}  // namespace
}  // namespace stope
