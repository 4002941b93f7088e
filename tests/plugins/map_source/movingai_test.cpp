#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <queue>

#include "plugins/map_source/movingai_scenario.hpp"
#include "tests/plugins/map_source/map_files.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_Movingai();

namespace stope::map_source {
namespace {

using Cells = std::vector<std::uint8_t>;
constexpr std::uint8_t kF = OccupancyGrid::kFree, kO = OccupancyGrid::kOccupied;

OccupancyGrid read(const std::filesystem::path& map, double resolution = 1.0) {
  stope::testing::StageHarness stage(stope_stage_Movingai());
  stope::testing::MemoryOutput<OccupancyGrid> grid;
  stage.set("map", map.string()).set("resolution", resolution).connect_output("grid", grid).run();
  return *grid.items.at(0).value;
}

TEST(MovingAi, ReadsEveryTerrainWithTheFirstRowOnTop) {
  const MapFolder folder;
  const auto file = folder.write("a.map", "type octile\nheight 2\nwidth 4\nmap\n.GS@\nOTW.\n");
  const OccupancyGrid grid = read(file, 2.5);
  EXPECT_EQ(grid.frame, (GridFrame{4, 2, 2.5, {}}));
  EXPECT_EQ(grid.cells, (Cells{kO, kO, kO, kF, kF, kF, kF, kO}));
}

TEST(MovingAi, ReadsCopiesWithCarriageReturnsAndWithoutTheLastLineEnd) {
  const MapFolder folder;
  const auto file = folder.write("a.map", "type octile\r\nheight 2\r\nwidth 2\r\nmap\r\n.@\r\n@.");
  EXPECT_EQ(read(file).cells, (Cells{kO, kF, kF, kO}));
}

TEST(MovingAi, SaysWhereAMapIsWrong) {
  const MapFolder folder;
  const auto error = [&](const std::string& text) {
    const auto file = folder.write("a.map", text);
    return stope::testing::error_of([&] { read(file); });
  };
  const std::string header = "type octile\nheight 2\nwidth 2\nmap\n";
  EXPECT_EQ(error(header + "..\n..\n\n"), "");
  EXPECT_NE(error("").find("a.map: the map is empty"), std::string::npos);
  EXPECT_NE(error("type octile\n").find("cut off before its rows"), std::string::npos);
  const std::string long_word = error("type " + std::string(5000, '\x1b') + "\n");
  EXPECT_LT(long_word.size(), 300U);
  EXPECT_EQ(long_word.find('\x1b'), std::string::npos);
  EXPECT_NE(error(header + "..\n.\x07\n").find("a.map:6:2: '?' is no terrain"), std::string::npos);
  EXPECT_NE(error("P5 2 2").find("a.map:1: this is not a MovingAI map"), std::string::npos);
  EXPECT_NE(error("type tile\n").find("a.map:1: the type is 'tile'"), std::string::npos);
  EXPECT_NE(error("type octile\nheight -2\n").find("a.map:2: 'height' is '-2'"), std::string::npos);
  EXPECT_NE(error("type octile\nheight 99999999999\n").find("a.map:2"), std::string::npos);
  EXPECT_NE(error("type octile\nheight 2\nmap\n").find("begins before"), std::string::npos);
  EXPECT_NE(error(header + "..\n").find("1 of 2 rows are missing"), std::string::npos);
  EXPECT_NE(error(header + "..\n. .\n").find("a.map:6: the row has 3 cells"), std::string::npos);
  EXPECT_NE(error(header + "..\n.x\n").find("a.map:6:2: 'x' is no terrain"), std::string::npos);
  EXPECT_NE(error(header + "..\n..\n..\n").find("a.map:7: there are more than the 2 rows"),
            std::string::npos);
  EXPECT_NE(error("type octile\nheight 2000000000\nwidth 2000000000\nmap\n..").find("is cut off"),
            std::string::npos);
}

TEST(MovingAiScenario, ReadsQueriesAndTurnsThemIntoCells) {
  const MapFolder folder;
  const auto file = folder.write("a.scen",
                                 "version 1\n0\ta.map\t4\t3\t0\t0\t3\t2\t3.82842712\n\n"
                                 "7 a.map 4 3 1 2 1 1 1\r\n");
  const auto queries = read_movingai_scenario(file);
  ASSERT_EQ(queries.size(), 2U);
  EXPECT_EQ(queries[0].map, "a.map");
  EXPECT_EQ(queries[0].start(), (Cell{0, 2}));
  EXPECT_EQ(queries[0].goal(), (Cell{3, 0}));
  EXPECT_EQ(queries[0].length, 3.82842712);
  EXPECT_EQ(queries[1].bucket, 7);
  EXPECT_EQ(queries[1].start(), (Cell{1, 0}));
}

TEST(MovingAiScenario, SaysWhereItIsWrong) {
  const MapFolder folder;
  const auto error = [&](const std::string& text) {
    const auto file = folder.write("a.scen", text);
    return stope::testing::error_of([&] { read_movingai_scenario(file); });
  };
  EXPECT_NE(error("").find("empty"), std::string::npos);
  EXPECT_NE(error("version 2\n").find("a.scen:1"), std::string::npos);
  EXPECT_NE(error("version 1\n0 a.map 4 3 0 0 3 2\n").find("a.scen:2: expected"),
            std::string::npos);
  EXPECT_NE(error("version 1\n0 a.map 4 3 0 0 4 2 1\n").find("outside of the map's 4 x 3"),
            std::string::npos);
  EXPECT_NE(error("version 1\n0 a.map 4 3 0 0 3 2 nan\n").find("a.scen:2"), std::string::npos);
}

/// Length of the shortest path over eight neighbours that cuts no corner, by Dijkstra.
double octile_length(const OccupancyGrid& grid, Cell start, Cell goal) {
  const GridFrame& frame = grid.frame;
  const auto free = [&](Cell cell) {
    return frame.contains(cell) && grid.cells[frame.place(cell)] == kF;
  };
  std::vector<double> best(frame.size(), 1e300);
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  if (free(start)) open.emplace(best[frame.place(start)] = 0, frame.place(start));
  while (!open.empty()) {
    const auto [length, place] = open.top();
    open.pop();
    if (length > best[place]) continue;
    const Cell at{static_cast<std::int32_t>(place % static_cast<std::size_t>(frame.width)),
                  static_cast<std::int32_t>(place / static_cast<std::size_t>(frame.width))};
    if (at == goal) return length;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell to{at.column + dx, at.row + dy};
        if (!free(to) || !free({at.column + dx, at.row}) || !free({at.column, at.row + dy}))
          continue;
        const double longer = length + (dx != 0 && dy != 0 ? std::sqrt(2.0) : 1.0);
        if (longer >= best[frame.place(to)]) continue;
        open.emplace(best[frame.place(to)] = longer, frame.place(to));
      }
    }
  }
  return -1;
}

TEST(MovingAiScenario, PublishedLengthsAreThoseOfTheGridWeRead) {
  const char* data = std::getenv("STOPE_DATA");
  const std::filesystem::path folder =
      (data ? std::filesystem::path(data)
            : std::filesystem::path(STOPE_SOURCE_DIR) / "../shared/data") /
      "movingai_cities";
  if (!std::filesystem::exists(folder / "Berlin_0_256.map"))
    GTEST_SKIP() << "STOPE_DATA has no movingai_cities, so no real scenario is read";
  for (const char* name : {"Berlin_0_256.map", "Boston_0_256.map"}) {
    const OccupancyGrid grid = read(folder / name);
    const auto queries = read_movingai_scenario(folder / (std::string(name) + ".scen"));
    ASSERT_GT(queries.size(), 500U);
    for (std::size_t i = 0; i < queries.size(); i += 97) {
      EXPECT_NEAR(octile_length(grid, queries[i].start(), queries[i].goal()), queries[i].length,
                  1e-4)
          << name << " query " << i;
    }
  }
}

}  // namespace
}  // namespace stope::map_source
