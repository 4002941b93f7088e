#include "plugins/topology/regions/shared_names.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "stope/digest.hpp"
#include "stope/random.hpp"
#include "tests/plugins/topology/random_changes.hpp"
#include "tests/plugins/topology/regions/region_stages.hpp"

namespace stope::topology {
namespace {

constexpr std::int32_t kNames = 30;

struct Names {
  Names(std::int32_t width, std::int32_t height) : cells(width, height) {
    std::fill_n(cells.data(), cells.size(), 0);
  }
  void give(std::int32_t column, std::int32_t row, Random& random) {
    cells[cells.index(column, row)] = static_cast<std::int32_t>(random.below(kNames));
  }
  std::vector<std::int32_t> labelled(const std::vector<std::int32_t>& label_of_name) const {
    std::vector<std::int32_t> labels;
    for (std::int32_t row = 0; row < cells.height(); ++row)
      for (std::int32_t column = 0; column < cells.width(); ++column)
        labels.push_back(label_of_name[static_cast<std::size_t>(cells[cells.index(column, row)])]);
    return labels;
  }
  PaddedGrid<std::int32_t> cells;
};

std::vector<std::int32_t> random_table(Random& random) {
  std::vector<std::int32_t> label_of_name;
  for (std::int32_t i = 0; i < kNames; ++i)
    label_of_name.push_back(static_cast<std::int32_t>(random.below(100)));
  return label_of_name;
}

TEST(SharedNames, FollowChangesAndLeaveEarlierLabelsAsTheyAre) {
  const std::pair<std::int32_t, std::int32_t> sizes[] = {{256, 64}, {300, 550}, {1, 270}, {129, 1}};
  for (const auto& [width, height] : sizes) {
    Random random(static_cast<std::uint64_t>(width));
    const auto below = [&](std::int32_t bound) {
      return static_cast<std::int32_t>(random.below(static_cast<std::uint64_t>(bound)));
    };
    Names names(width, height);
    for (std::int32_t row = 0; row < height; ++row)
      for (std::int32_t column = 0; column < width; ++column) names.give(column, row, random);
    SharedNames shared(names.cells, never_stop);
    std::vector<LabelCells> given;
    std::vector<std::vector<std::int32_t>> expected;
    for (int i = 0; i < 25; ++i) {
      ChangedSquares changed(width, height);
      for (int cells = below(20); cells > 0; --cells) {
        const std::int32_t column = below(width), row = below(height);
        names.give(column, row, random);
        changed.add(column, row);
      }
      shared.update(names.cells, changed, never_stop);
      const std::vector<std::int32_t> label_of_name = random_table(random);
      given.push_back(shared.labelled(label_of_name));
      expected.push_back(names.labelled(label_of_name));
      for (std::size_t k = 0; k < given.size(); ++k)
        ASSERT_EQ(given[k].to_vector(), expected[k]) << width << " x " << height << ", " << k;
    }
  }
}

TEST(SharedNames, AreNotLookedAtWhereNothingHasChanged) {
  Random random(5);
  Names names(200, 200);
  SharedNames shared(names.cells, never_stop);
  names.cells[names.cells.index(10, 10)] = names.cells[names.cells.index(190, 190)] = 1;
  ChangedSquares changed(200, 200);
  changed.add(10, 10);
  shared.update(names.cells, changed, never_stop);
  const LabelCells labels = shared.labelled({0, 7});
  EXPECT_EQ(labels[10 * 200 + 10], 7);
  EXPECT_EQ(labels[190 * 200 + 190], 0);
}

TEST(RegionStages, LeaveTheMapsOfEarlierItemsAsTheyWere) {
  for (const StageEntry* entry : region_stages()) {
    OccupancyGrid grid = random_grid(210, 150, 0.9, 9, 3);
    grid.frame.resolution = 0.1;
    Random random(3);
    StageHarness stage = for_rooms(entry);
    stage.set("allow_empty", true);
    std::vector<RegionMap> given;
    std::vector<Digest> digests;
    std::size_t differ = 0;
    for (std::uint64_t item = 0; item < 20; ++item) {
      const auto kind = static_cast<ChangeKind>(item % kChangeKinds);
      const CellWindow window = change_at_random(grid, 30, kind, random);
      grid.changed = ChangedWindow{window.column, window.row, window.width, window.height,
                                   item > 0 ? item - 1 : 1000};
      stage.input("grid", grid).context().item = item;
      given.push_back(stage.apply<RegionMap>(1));
      digests.push_back(digest_of(given.back()));
      if (item > 0 && digests[item] != digests[item - 1]) ++differ;
    }
    EXPECT_GT(differ, 10U);
    for (std::size_t item = 0; item < given.size(); ++item)
      EXPECT_EQ(digest_of(given[item]), digests[item]) << item;
  }
}

}  // namespace
}  // namespace stope::topology
