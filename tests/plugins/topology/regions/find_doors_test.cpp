#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "plugins/topology/regions/doors.hpp"
#include "plugins/topology/regions/room_divider.hpp"
#include "stope/digest.hpp"
#include "tests/plugins/topology/everything.hpp"
#include "tests/plugins/topology/regions/doors_by_flooding.hpp"
#include "tests/plugins/topology/regions/region_stages.hpp"

namespace stope::topology {
namespace {

constexpr std::int32_t kWidth = 75, kHeight = 70;

/// Regions of several names each, in blocks that cross tiles; some names have none.
struct Labelled {
  explicit Labelled(std::uint64_t seed)
      : ground(random_grid(kWidth, kHeight, 0.8, seed % 2 == 0 ? 1 : 3, seed), everything()),
        names(kWidth, kHeight),
        tiles(kWidth, kHeight) {
    constexpr std::int32_t kNames = 12;
    Random random(seed + 500);
    const auto block = static_cast<std::int32_t>(2 + 5 * (seed % 3));
    std::vector<std::int32_t> of_block;
    for (std::int32_t i = 0; i < kWidth * kHeight; ++i)
      of_block.push_back(1 + static_cast<std::int32_t>(random.below(kNames)));
    for (std::int32_t row = -1; row <= kHeight; ++row)
      for (std::int32_t column = -1; column <= kWidth; ++column) {
        const CellIndex cell = ground.index(column, row);
        names[cell] =
            ground.free(cell)
                ? of_block[static_cast<std::size_t>(row / block * kWidth + column / block)]
                : 0;
      }
    for (std::int32_t name = 0; name <= kNames; ++name)
      set.of_name.push_back(name < 2 ? 0 : 1 + name % 3);
    set.count = 3;
    tiles.look_at(ground, names, all_tiles(ground), never_stop);
  }
  std::int32_t region(std::int32_t column, std::int32_t row) const {
    return set.of(names[ground.index(column, row)]);
  }

  Ground ground;
  PaddedGrid<std::int32_t> names;
  TileParts tiles;
  RegionSet set;
};

using PlacedDoor = std::tuple<std::int32_t, std::int32_t, CellIndex, CellIndex, std::int32_t>;

PlacedDoor door_of(const Border& border) {
  return {border.a, border.b, border.low, border.high, border.steps};
}

/// The clearest cells of each door of the lattice, and how many pairs there are.
std::vector<Border> expected_doors(const Labelled& map) {
  const DoorsByFlooding flooded(kWidth, kHeight, [&](std::int32_t column, std::int32_t row) {
    return map.region(column, row);
  });
  std::map<std::tuple<std::int32_t, std::int32_t, std::int32_t>, Border> doors;
  for (std::int32_t row = 0; row < kHeight; ++row)
    for (std::int32_t column = 0; column < kWidth; ++column)
      for (std::int32_t y = std::max(0, row - 1); y < std::min(kHeight, row + 2); ++y)
        for (std::int32_t x = std::max(0, column - 1); x < std::min(kWidth, column + 2); ++x) {
          const std::int32_t a = map.region(column, row), b = map.region(x, y);
          if (a == 0 || a >= b) continue;
          Border found{a, b, 1, 0, map.ground.index(column, row), map.ground.index(x, y)};
          if (is_uphill(map.ground, found.low, found.high)) std::swap(found.low, found.high);
          found.squared = map.ground.squared(found.low);
          const std::int32_t door = flooded.door_at({a, b}, {column + x + 1, row + y + 1});
          const auto [known, is_new] = doors.emplace(std::tuple(a, b, door), found);
          if (is_new) continue;
          const std::int32_t steps = known->second.steps + 1;
          if (is_clearer(found, known->second)) known->second = found;
          known->second.steps = steps;
        }
  std::vector<Border> list;
  for (const auto& [key, door] : doors) list.push_back(door);
  return list;
}

TEST(FindDoors, AreTheConnectedPiecesOfWhatTwoRegionsHaveInCommon) {
  std::size_t most = 0;
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    const Labelled map(seed);
    const std::vector<Contact> contacts = all_contacts(map.tiles);
    const std::vector<Border> all = expected_doors(map);
    const std::vector<Border> borders = find_borders(contacts, map.set);
    for (const std::int32_t least : {1, 4, 1000}) {
      std::vector<PlacedDoor> expected, found;
      std::size_t pairs = 0;
      for (const Border& door : all)
        if (door.squared >= least || std::any_of(borders.begin(), borders.end(), [&](auto& border) {
              return border.low == door.low && border.high == door.high;
            }))
          expected.push_back(door_of(door));
      const SameRegions none{std::vector<std::uint8_t>(static_cast<std::size_t>(map.set.count), 0),
                             {}};
      for (const auto& [door, before] :
           find_doors(map.ground, map.names, map.set, contacts, least, none, {}, never_stop)) {
        EXPECT_EQ(before, -1);
        // The first of two regions is their border.
        if (found.empty() || std::get<0>(found.back()) != door.a ||
            std::get<1>(found.back()) != door.b) {
          ASSERT_LT(pairs, borders.size());
          EXPECT_EQ(door.low, borders[pairs].low);
          EXPECT_EQ(door.high, borders[pairs].high);
          ++pairs;
        }
        found.push_back(door_of(door));
      }
      EXPECT_EQ(pairs, borders.size());
      most = std::max(most, found.size() - pairs);
      std::sort(expected.begin(), expected.end());
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, expected) << "seed " << seed << ", least " << least;
    }
  }
  EXPECT_GT(most, 20U);
}

/// Two rooms of 4 x 4 m with two doors between them of these widths, in cells of 0.1 m.
OccupancyGrid ring_of_two_rooms(double lower, double upper) {
  return grid_where(8.8, 4.4, 0.1, [&](double x, double y) {
    const bool room = x > 0.2 && x < 8.6 && y > 0.2 && y < 4.2;
    const bool door = std::abs(y - 1.2) < lower / 2 || std::abs(y - 3.2) < upper / 2;
    return room && (door || x < 4.2 || x > 4.6);
  });
}

TEST(VoronoiRegions, ARingOfTwoRoomsHasARoadThroughEachDoorThatIsWideEnough) {
  const auto roads_of = [](double lower, double upper, const char* network) {
    StageHarness stage = for_rooms(stope_stage_VoronoiRegions());
    // The wall between the doors is an obstacle of its own, of 0.44 m^2.
    stage.set("min_obstacle_area", 0.1)
        .set("allow_empty", true)
        .set("network", std::string(network));
    stage.input("grid", ring_of_two_rooms(lower, upper));
    const auto map = stage.apply<RegionMap>(1);
    EXPECT_EQ(map.regions.size(), 2U);
    EXPECT_EQ(map.adjacency, (std::vector<std::uint32_t>{0, 1}));
    return stage.apply<RoadGraph>(0);
  };
  const RoadGraph ring = roads_of(0.8, 1, "none");
  ASSERT_EQ(ring.nodes.size(), 2U);
  ASSERT_EQ(ring.edges.size(), 2U);  // a cycle, around the wall between the doors
  // One leads through each door, at the wall's middle.
  std::vector<double> crossings;
  for (const RoadEdge& edge : ring.edges) {
    EXPECT_NE(edge.from, edge.to);
    const auto line = ring.polyline(edge);
    for (std::size_t i = 1; i < line.size(); ++i)
      if ((line[i - 1].x < 4.4) != (line[i].x < 4.4))
        crossings.push_back(line[i - 1].y + (4.4 - line[i - 1].x) / (line[i].x - line[i - 1].x) *
                                                (line[i].y - line[i - 1].y));
  }
  ASSERT_EQ(crossings.size(), 2U);
  std::sort(crossings.begin(), crossings.end());
  EXPECT_NEAR(crossings[0], 1.2, 0.15);
  EXPECT_NEAR(crossings[1], 3.2, 0.15);
  EXPECT_NE(ring.edges[0].id, ring.edges[1].id);
  // A tree has no cycle; to a spanner the other door is a way from room to room that is no longer.
  EXPECT_EQ(roads_of(0.8, 1, "mst").edges.size(), 1U);
  EXPECT_EQ(roads_of(0.8, 1, "spanner").edges.size(), 1U);
  // Roads keep 0.2 m from obstacles.
  EXPECT_EQ(roads_of(0.3, 1, "none").edges.size(), 1U);
  EXPECT_EQ(roads_of(0.3, 0.3, "none").edges.size(), 0U);
}

TEST(RoomDivider, FollowsDoorsThatOpenAndClose) {
  constexpr std::int32_t kDoors = 4, kWall = 44;
  ExtractionParams extraction;
  extraction.min_obstacle_area = 0;
  extraction.min_clearance = 1;
  const RoomDivider::Rule rule{0.8, 1, 1, 0};
  OccupancyGrid grid = grid_where(90, 120, 1, [](double x, double y) {
    return x > 2 && x < 88 && y > 2 && y < 118 && (x < kWall || x > kWall + 2);
  });
  RoomDivider divider(extraction, rule, {1, 0.2, Network::kAll, 1.5});
  divider.full(grid, true);
  Random random(3);
  std::vector<bool> open(kDoors, false);
  for (int i = 0; i < 40; ++i) {
    const auto door = random.below(kDoors);
    open[door] = !open[door];
    const CellWindow window{kWall, 15 + 25 * static_cast<std::int32_t>(door), 2, 8};
    for (std::int32_t y = window.row; y < window.row + window.height; ++y)
      for (std::int32_t x = window.column; x < window.column + window.width; ++x)
        grid.cells[grid.frame.place({x, y})] =
            open[door] ? OccupancyGrid::kFree : OccupancyGrid::kOccupied;
    const RegionsAndRoads now = divider.update(grid, window);
    ASSERT_EQ(now.map.regions.size(), 2U);
    EXPECT_EQ(now.roads.edges.size(), std::count(open.begin(), open.end(), true)) << i;
    EXPECT_EQ(now.map.adjacency.size(), now.roads.edges.empty() ? 0U : 2U);
    const RegionsAndRoads expected =
        RoomDivider(extraction, rule, {1, 0.2, Network::kAll, 1.5}).full(grid, false);
    ASSERT_EQ(digest_of(now.map), digest_of(expected.map)) << i;
    ASSERT_EQ(digest_of(now.roads), digest_of(expected.roads)) << i;
  }
}

}  // namespace
}  // namespace stope::topology
