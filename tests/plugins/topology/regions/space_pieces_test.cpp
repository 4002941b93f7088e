#include "plugins/topology/regions/space_pieces.hpp"

#include <gtest/gtest.h>

#include "plugins/topology/regions/basins.hpp"
#include "plugins/topology/regions/borders.hpp"
#include "tests/plugins/topology/test_grids.hpp"

namespace stope::topology {
namespace {

TEST(SpacePieces, AreAsManyByNamesAsByRows) {
  std::size_t most = 0, nameless = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    ExtractionParams params;
    params.min_obstacle_area = 0;
    const Ground ground(random_grid(120, 100, 0.55, 5, seed), params);
    PaddedGrid<std::int32_t> names = Basins(ground).take_cells();
    // A few cells lose their name, also those that are all that joins two others.
    Random random(seed);
    for (int i = 0; i < 12; ++i)
      names[ground.index(static_cast<std::int32_t>(random.below(120)),
                         static_cast<std::int32_t>(random.below(100)))] = 0;
    TileParts tiles(ground.width(), ground.height());
    tiles.look_at(ground, names, all_tiles(ground), never_stop);
    RegionSet set;
    std::int32_t last = 0;
    for (std::size_t i = 0; i < ground.size(); ++i)
      last = std::max(last, names[static_cast<CellIndex>(i)]);
    for (std::int32_t name = 0; name <= last; ++name)
      set.of_name.push_back(name == 0 || random.uniform() < 0.4 ? 0 : ++set.count);
    const std::size_t expected = count_pieces_by_rows(ground, names, set, never_stop);
    EXPECT_EQ(count_space_pieces(ground, names, tiles, all_contacts(tiles), set, never_stop),
              expected)
        << seed;
    most = std::max(most, expected);
    for (std::size_t tile = 0; tile < tiles.size(); ++tile)
      nameless += static_cast<std::size_t>(tiles.nameless(tile));
  }
  EXPECT_GT(most, 5U);
  EXPECT_GT(nameless, 60U);
}

}  // namespace
}  // namespace stope::topology
